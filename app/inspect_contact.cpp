// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>

#include "app/commands.h"
#include "app/inspect/inspect_options.h"
#include "app/inspect/ledger_report.h"
#include "solver/base/error.h"

namespace hydroscope {

ExitCode inspect_contact(const Arguments& arguments) {
  const InspectOptions options = parse_inspect_options(arguments);
  const std::filesystem::path path = arguments.operands.front();
  const Ledger ledger = read_ledger({path});
  const std::string report = make_inspect_report(ledger, options, path.string());
  if (std::fputs(report.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw EnvironmentError("the report cannot be written");
  return ExitCode::kDone;
}

}  // namespace hydroscope
