// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/check/check_report.h"

#include <array>
#include <cstdio>
#include <regex>

#include "render/frame_files.h"
#include "render/image/image_difference.h"
#include "render/image/png_file.h"
#include "solver/base/error.h"
#include "solver/base/whole_file.h"

namespace hydroscope {
namespace {

namespace fs = std::filesystem;

std::string print_seconds(double seconds) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.2f", seconds);
  return text.data();
}

std::string escape_xml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += static_cast<unsigned char>(c) < 0x20 && c != '\n' ? ' ' : c;
  }
  return out;
}

/// A test case with the findings that belong to it; returns whether it failed.
bool add_case(const CheckReport& report, const std::string& name, const std::string& view, int frame,
              std::string& xml) {
  std::string failures;
  for (const Finding& finding : report.findings) {
    // What concerns a frame in all views is told with its first case.
    if (finding.view != view || finding.frame != frame) continue;
    failures += "      <failure type=\"" + std::string(to_string(finding.stage)) + "\" message=\"" +
                escape_xml(finding.text) + "\"/>\n";
  }
  xml += "    <testcase classname=\"" + escape_xml(view.empty() ? "all-views" : view) + "\" name=\"" +
         escape_xml(name) + "\"";
  xml += failures.empty() ? "/>\n" : ">\n" + failures + "    </testcase>\n";
  return !failures.empty();
}

/// Files that a check writes, relative to its folder.
const std::regex& known_files() {
  static const std::regex pattern(R"(index\.html|junit\.xml|[a-z-]+/\d{5,}-(expected|got|difference)\.png)");
  return pattern;
}

void remove_earlier(const fs::path& folder) {
  if (!fs::exists(folder)) return;
  std::vector<fs::path> old;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = entry.path().lexically_relative(folder).generic_string();
    if (entry.is_regular_file() && std::regex_match(name, known_files())) old.push_back(entry.path());
  }
  for (const fs::path& file : old) fs::remove(file);
}

}  // namespace

std::string make_text_report(const CheckReport& report, int most_lines) {
  std::string text;
  for (const std::string& note : report.notes) text += "note: " + note + "\n";
  const int count = static_cast<int>(report.findings.size());
  for (int i = 0; i < std::min(count, most_lines); ++i)
    text += "DIFFERENT " + describe(report.findings[static_cast<std::size_t>(i)]) + "\n";
  if (count > most_lines) text += "... and " + std::to_string(count - most_lines) + " more\n";
  text += std::to_string(report.frames) + " frames: " + std::to_string(report.sidecars_compared) +
          " sidecars, " + std::to_string(report.pictures_compared) + " pictures (" +
          (report.is_same_renderer ? "pixel by pixel" : "by structure") + "), " +
          std::to_string(report.class_passes) + " class passes in " + print_seconds(report.seconds) + " s\n";
  std::array<char, 120> worst{};
  if (report.is_same_renderer)
    std::snprintf(worst.data(), worst.size(),
                  "pictures differ in at most %.3g %% of their pixels, by at most %d\n",
                  100.0 * report.largest_share_off, report.largest_difference);
  else
    std::snprintf(worst.data(), worst.size(), "least likeness of any window: %.3f\n", report.least_likeness);
  if (report.pictures_compared > 0) text += worst.data();
  text += "renderer: " + report.renderer + "\n";
  return text + (report.is_passed() ? "as the baseline\n"
                                    : std::to_string(count) + " differences from the baseline\n");
}

std::string make_junit_report(const CheckReport& report, const Baseline& baseline, const std::string& suite) {
  std::string cases;
  int tests = 0, failures = 0;
  const auto add = [&](const std::string& name, const std::string& view, int frame) {
    ++tests;
    failures += add_case(report, name, view, frame, cases) ? 1 : 0;
  };
  add("sequence", "", 0);
  int frames = std::max(report.frames, static_cast<int>(baseline.states.size()));
  for (const Finding& finding : report.findings) frames = std::max(frames, finding.frame);
  for (int frame = 1; frame <= frames; ++frame) {
    add("frame " + std::to_string(frame), "", frame);
    for (const std::string& view : baseline.options.views) add("frame " + std::to_string(frame), view, frame);
  }
  const std::string numbers = " tests=\"" + std::to_string(tests) + "\" failures=\"" +
                              std::to_string(failures) + "\" time=\"" + print_seconds(report.seconds) + "\"";
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" + numbers + ">\n  <testsuite name=\"" +
         escape_xml(suite) + "\"" + numbers +
         " errors=\"0\">\n    <properties>\n      <property name=\"renderer\" value=\"" +
         escape_xml(report.renderer) + "\"/>\n    </properties>\n" + cases +
         "  </testsuite>\n</testsuites>\n";
}

void write_check_report(const CheckReport& report, const Baseline& baseline, const std::string& name,
                        const fs::path& folder) {
  try {
    remove_earlier(folder);
  } catch (const fs::filesystem_error& error) {
    throw EnvironmentError(folder.string() + ": cannot be written: " + error.code().message());
  }
  make_folder(folder);
  write_whole_file(folder / "junit.xml", make_junit_report(report, baseline, name));
  if (report.is_passed()) return;
  for (const PictureFinding& picture : report.pictures) {
    make_folder(folder / picture.view);
    const std::string start = make_frame_name(folder.string(), picture.view, picture.frame);
    write_png(start + "-expected.png", picture.expected);
    write_png(start + "-got.png", picture.got, {{"Renderer", report.renderer}});
    if (picture.expected.width == picture.got.width && picture.expected.height == picture.got.height)
      write_png(start + "-difference.png", make_difference_picture(picture.expected, picture.got));
  }
  write_whole_file(folder / "index.html", make_html_report(report, name));
}

}  // namespace hydroscope
