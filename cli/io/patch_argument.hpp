// SPDX-License-Identifier: MIT
#pragma once

#include "cli/io/memory_columns.hpp"
#include "cli/io/messages.hpp"

#include "limitcurve/laws.hpp"
#include "limitcurve/measured/samples.hpp"
#include "limitcurve/patch/patch_table.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace limitcurve::cli {

/// All that makes a patch, the numbers of its file among them.
struct PatchArgument {
  std::string kind;                  ///< points, polygon, rectangle, ellipse, image or table
  std::string text = {};             ///< as it was given, for messages; empty for arrays
  std::string file = {};             ///< likewise
  std::vector<double> numbers = {};  ///< row by row
  std::size_t columns = 0;
  std::size_t without_sensor = 0;  ///< pixels
  bool frames_in_blocks = false;   ///< of an image: blank lines part its rows
  double x = 0.0;                  ///< sides of a rectangle or of a pixel, semi-axes of an ellipse [m]
  double y = 0.0;
  std::string law = {};  ///< of an ellipse
  std::vector<PressureSample> profile = {};
  double mx = 1.0;
  double my = 1.0;
  std::optional<PatchTable> table = {};  ///< that was read or made
  std::optional<double> floor = {};      ///< of an image: see Patch::image
  std::vector<std::string> notes = {};   ///< on its file

  /// Throws std::invalid_argument with text, file and the place of the error in it.
  [[nodiscard]] Patch patch() const;
  /// What a user must know of the patch `made`, and what is to be asked: "note: …", "warning: …". The unit of arrays is
  /// not asked.
  [[nodiscard]] std::vector<std::string> remarks(const Patch& made) const;

 private:
  /// Its longest side [m].
  [[nodiscard]] double across() const;
};

/// A patch in memory (Python's), which parse_patch finds by its path.
class MemoryPatch : public MemoryColumns {
 public:
  /// `name` stands for the patch in messages and in columns.
  MemoryPatch(std::string name, PatchArgument patch)
      : MemoryColumns(std::move(name), {}, {}, {}), patch_(std::move(patch)) {}
  [[nodiscard]] const PatchArgument& patch() const { return patch_; }

 private:
  PatchArgument patch_;
};

/// Reads a patch from a command line: `points:FILE.csv` (columns x,y,load), `polygon:FILE.csv` (x,y),
/// `rectangle:x=0.02,y=0.01` (full sides), `ellipse:law=hertz,a=0.004,b=0.002`, `image:FILE.csv,pixel=0.0005` (rows of
/// pressures, no header; `pixel=0.004x0.005` along x and y), each with `,mx=…,my=…` if friction differs along x and y.
/// An empty pixel, `B` or `nan` has no sensor, and counts as without pressure. With `columns=32`, or if the first row
/// is the size `32,32`, each row of an image is a frame, flattened; `frame=2` says which of the frames. `skip=1` leaves
/// out the first field of each row, a time; rows of text before the numbers are skipped. Negative pressures are noise;
/// `floor=P` says up to which pressure. An image may be an ASCII file of Tekscan's, whose header has the sides of a
/// pixel. `table:FILE` is a table that `limitcurve table --patch` wrote. Throws std::invalid_argument with the place of
/// the error in the text or in the file.
PatchArgument parse_patch(const std::string& text);
/// The patch itself; says its remarks.
Patch read_patch(const std::string& text, Messages& messages);

/// Says by what the discs of a patch with friction factors multiply mu.
void note_factor(Messages& messages, const Patch& patch);

}  // namespace limitcurve::cli
