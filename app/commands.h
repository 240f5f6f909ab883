// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line.h"
#include "app/exit_code.h"

namespace hydroscope {

// One function a command. They throw InputError, EnvironmentError and ContractError;
// main() turns these into messages and exit codes.

/// Solves a scene and records it.
ExitCode run_scene(const Arguments& arguments);
/// Repeats the acts of a journal: `run --replay`.
ExitCode replay_journal(const Arguments& arguments);
/// Steers an analysis from a terminal or a script.
ExitCode open_console(const Arguments& arguments);
/// Draws saved states again.
ExitCode render_results(const Arguments& arguments);
/// Compares saved states with an approved sequence.
ExitCode check_results(const Arguments& arguments);
/// Shows and steers a scene, or shows results, in a browser.
ExitCode serve(const Arguments& arguments);
/// Lists the detachments of a run and why they came.
ExitCode inspect_contact(const Arguments& arguments);
/// Runs a grid of settings over scenes and draws what it shows.
ExitCode chart_study(const Arguments& arguments);
/// Reports on a tool mesh and draws it.
ExitCode inspect_tool_mesh(const Arguments& arguments);

}  // namespace hydroscope
