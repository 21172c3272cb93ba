// SPDX-License-Identifier: MIT
#pragma once

#include "cli/commands/subcommand.hpp"

#include <memory>

/// The subcommands, one file each; p-curves and c-curves share one.
namespace limitcurve::cli {

std::unique_ptr<Subcommand> make_laws();
std::unique_ptr<Subcommand> make_eval();
std::unique_ptr<Subcommand> make_curve();
std::unique_ptr<Subcommand> make_p_curves();
std::unique_ptr<Subcommand> make_c_curves();
std::unique_ptr<Subcommand> make_table();
std::unique_ptr<Subcommand> make_lookup();
std::unique_ptr<Subcommand> make_validate();
std::unique_ptr<Subcommand> make_choose();
std::unique_ptr<Subcommand> make_fit();
std::unique_ptr<Subcommand> make_translate();
std::unique_ptr<Subcommand> make_replay();
std::unique_ptr<Subcommand> make_pivot();
std::unique_ptr<Subcommand> make_patch();
std::unique_ptr<Subcommand> make_hold();

}  // namespace limitcurve::cli
