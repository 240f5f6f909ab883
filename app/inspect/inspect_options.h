// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line.h"
#include "app/inspect/ledger_filter.h"

namespace hydroscope {

enum class LedgerFormat { kText, kJson, kCsv };

/// What the command line of `hydroscope inspect` asks for.
struct InspectOptions {
  LedgerFilter filter;  ///< without the tool, whose name only the run knows
  std::string tool;     ///< its name; empty: all
  std::optional<int> node;
  LedgerFormat format = LedgerFormat::kText;
  int most = 20;  ///< lines of a table for people; 0: all
};

/// Throws InputError that names the option.
InspectOptions parse_inspect_options(const Arguments& arguments);

/// The ledger, or the life of the node, as asked for. Throws InputError when the
/// run has no such tool or node.
std::string make_inspect_report(const Ledger& ledger, const InspectOptions& options, const std::string& name);

}  // namespace hydroscope
