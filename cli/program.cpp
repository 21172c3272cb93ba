// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"
#include "cli/io/descriptor.hpp"
#include "cli/io/messages.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace limitcurve::cli {

namespace {

/// One line, whatever the message quotes.
void complain(std::string_view message) {
  std::string line = descriptor::takes_colours(descriptor::standard_error) ? "limitcurve: \x1b[31merror:\x1b[0m "
                                                                           : "limitcurve: error: ";
  for (const char character : message)
    line += static_cast<unsigned char>(character) < 0x20 || character == 0x7f ? '?' : character;
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

int run_program(const std::vector<std::string>& arguments) {
  descriptor::prepare_standard_streams();
  try {
    Messages messages(Messages::Kind::notes_and_progress);
    auto output = OutputFile::standard_output();
    if (descriptor::draws(descriptor::standard_output)) output.before_writing([&] { messages.stop(); });
    const Format format = descriptor::is_terminal(descriptor::standard_output) ? Format::table : Format::csv;
    run_command_line(arguments, {.output = output, .format = format, .messages = &messages});
    return 0;
  } catch (const NoSubcommand& error) {
    std::fputs(error.what(), stderr);
    return 2;
  } catch (const std::invalid_argument& error) {
    complain(error.what());
    return 2;
  } catch (const ClosedPipe&) {
    return 1;
  } catch (const std::exception& error) {
    complain(error.what());
    return 1;
  }
}

}  // namespace limitcurve::cli
