// SPDX-License-Identifier: MIT
#include "limitcurve/patch.hpp"

#include "cli/commands/subcommands.hpp"
#include "cli/io/patch_argument.hpp"
#include "cli/io/unit_questions.hpp"

namespace limitcurve::cli {

namespace {

class PatchCommand final : public Subcommand {
 public:
  [[nodiscard]] Manual manual() const override {
    return {"patch", "Friction of a contact that is not round: the wrench of each sliding twist",
            "Patches: points:FILE.csv (columns x,y,load), polygon:FILE.csv (x,y), rectangle:x=0.02,y=0.01 (full sides),\n"
            "ellipse:law=hertz,a=0.004,b=0.002 (semi-axes), image:FILE.csv,pixel=0.0005 (rows of pressures, the first row at the\n"
            "largest y; the origin is the centre of pressure; pixel=0.004x0.005 along x and y; an empty pixel, B or nan has no sensor; a\n"
            "file of Tekscan's has its pixel; columns=32: each row of the file is a frame, flattened; frame=2 selects). Append "
            ",mx=...,my=... if friction along x and y differs: they multiply\n"
            "mu. Lengths are in metres; loads and pressures may have any unit.\n"
            "Twists: a CSV with the columns vx,vy,omega [m/s, rad/s], the velocity of the patch over the ground at the origin.\n"
            "Columns: the twist; fx, fy, moment: the wrench about the origin that keeps the patch sliding; power = mu P H; error, a\n"
            "bound of the largest of the relative error of power, |dF|/(mu P) and |dM|/(mu P m0).",
            "limitcurve patch --patch rectangle:x=0.02,y=0.01 --twists data/patches/twists.csv --mu 0.5 --load 4"};
  }

  void declare(Options& options) override {
    options.text("--patch", patch_, "PATCH", "Pressure patch (see below)", Presence::required);
    options.text("--twists", twists_, "FILE", "CSV of twists, or - for standard input", Presence::required);
    options.number("--mu", mu_, positive, "Coefficient of friction");
    options.number("--load", load_, positive, "Normal load P [N]");
  }

  void run(const Results& results) override {
    const Patch patch = read_patch(patch_, *results.messages);
    UnitQuestions questions;
    questions.load(load_);
    results.messages->say(questions.lines());
    Rows rows(results, {"vx", "vy", "omega", "fx", "fy", "moment", "power", "error"});
    const double limit = mu_ * load_;
    read_twists(twists_, [&](const PatchTwist& twist) {
      const PatchFriction friction = patch.about_origin(twist);
      rows.row(twist.vx, twist.vy, twist.omega, limit * friction.wrench.fx, limit * friction.wrench.fy, limit * friction.wrench.moment,
               limit * friction.power, friction.error);
    });
    rows.finish();
  }

 private:
  std::string patch_;
  std::string twists_;
  double mu_ = 1.0;
  double load_ = 1.0;
};

}  // namespace

std::unique_ptr<Subcommand> make_patch() {
  return std::make_unique<PatchCommand>();
}

}  // namespace limitcurve::cli
