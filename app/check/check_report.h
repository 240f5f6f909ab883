// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/check/baseline.h"
#include "app/check/finding.h"

namespace hydroscope {

/// What the terminal shows: a line a finding (at most `most_lines` of them), and the result.
std::string make_text_report(const CheckReport& report, int most_lines = 30);

/// JUnit XML: a test case for the sequence, and one a view and frame.
std::string make_junit_report(const CheckReport& report, const Baseline& baseline, const std::string& suite);

/// One page without other files: all findings, and for each rejected picture (at most
/// kMostPictures) what was expected, what came, a slider between the two, and the difference.
std::string make_html_report(const CheckReport& report, const std::string& title);

/// Writes junit.xml; for a rejected sequence index.html and VIEW/00001-expected.png, -got.png and
/// -difference.png, too. What an earlier check left in `folder` is removed. Throws EnvironmentError.
void write_check_report(const CheckReport& report, const Baseline& baseline, const std::string& name,
                        const std::filesystem::path& folder);

}  // namespace hydroscope
