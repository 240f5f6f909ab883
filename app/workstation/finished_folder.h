// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "app/workstation/board.h"

namespace hydroscope {

/// Puts a run's folder with its branches on the board, to be looked at: tables from CSV, states when they
/// are asked for. A run that was broken off will do. Throws InputError.
void read_finished_folder(const std::filesystem::path& results, Board& board);

}  // namespace hydroscope
