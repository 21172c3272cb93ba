// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"
#include "cli/io/descriptor.hpp"

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>

namespace {

/// One line, whatever the message quotes.
void complain(std::string_view message) {
  std::string line = "limitcurve: error: ";
  for (const char character : message) line += static_cast<unsigned char>(character) < 0x20 || character == 0x7f ? '?' : character;
  std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

int main(int argc, char** argv) {
  limitcurve::cli::descriptor::prepare_standard_streams();
  try {
    auto output = limitcurve::cli::OutputFile::standard_output();
    limitcurve::cli::run_command_line({argv + 1, argv + argc}, {output});
    return 0;
  } catch (const std::invalid_argument& error) {
    complain(error.what());
    return 2;
  } catch (const std::exception& error) {
    complain(error.what());
    return 1;
  }
}
