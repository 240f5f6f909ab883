// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string_view>

#include "app/check/check_report.h"
#include "render/image/image_difference.h"
#include "render/image/png_file.h"

namespace hydroscope {
namespace {

constexpr std::size_t kMostPictures = 20;  // a page of a few MB opens everywhere
constexpr std::size_t kMostFindings = 500;

std::string escape_html(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else
      out += c;
  }
  return out;
}

std::string make_base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k > bytes.size() ? '=' : kDigits[group >> (18U - 6U * k) & 63U];
  }
  return out;
}

std::string make_image_tag(const Image& image, const char* what) {
  return std::string("<img alt=\"") + what + "\" src=\"data:image/png;base64," +
         make_base64(make_png(image, {}, PngSize::kSmall)) + "\">";
}

constexpr const char* kHead = R"(<meta charset="utf-8">
<style>
body { font: 15px/1.5 sans-serif; margin: 2em auto; max-width: 1300px; padding: 0 1em; color: #222; }
li b { font-weight: 600; }
figure { margin: 0; }
figcaption { color: #666; }
.row { display: grid; grid-template-columns: repeat(auto-fit, minmax(380px, 1fr)); gap: 1em; }
img { width: 100%; image-rendering: pixelated; display: block; }
.slide { position: relative; }
.slide .over { position: absolute; inset: 0; clip-path: inset(0 0 0 var(--at, 50%)); }
input { width: 100%; margin: 0; }
</style>
)";

void add_picture(const PictureFinding& picture, std::string& page) {
  const std::string expected = make_image_tag(picture.expected, "expected");
  const std::string got = make_image_tag(picture.got, "got");
  const bool is_one_size =
      picture.expected.width == picture.got.width && picture.expected.height == picture.got.height;
  page += "<h2>" + escape_html(picture.view) + ", frame " + std::to_string(picture.frame) + "</h2>\n<p>" +
          escape_html(picture.text) + "</p>\n<div class=\"row\">\n";
  page += "<figure><div class=\"slide\">" + expected + "<div class=\"over\">" + got +
          "</div></div><input type=\"range\" value=\"50\" aria-label=\"border between the pictures\" "
          "oninput=\"this.previousElementSibling.style.setProperty('--at', this.value + '%')\">"
          "<figcaption>left of the slider: expected, right: got</figcaption></figure>\n";
  if (is_one_size)
    page += "<figure>" +
            make_image_tag(make_difference_picture(picture.expected, picture.got), "difference") +
            "<figcaption>difference, eight times as large</figcaption></figure>\n";
  page += "<figure>" + expected + "<figcaption>expected</figcaption></figure>\n<figure>" + got +
          "<figcaption>got</figcaption></figure>\n</div>\n";
}

}  // namespace

std::string make_html_report(const CheckReport& report, const std::string& title) {
  std::string page = "<!doctype html>\n<html lang=\"en\">\n<title>Check of " + escape_html(title) +
                     "</title>\n" + kHead + "<h1>" + escape_html(title) + ": " +
                     std::to_string(report.findings.size()) + " differences from the baseline</h1>\n<p>" +
                     escape_html(report.renderer) + "</p>\n";
  for (const std::string& note : report.notes) page += "<p>" + escape_html(note) + "</p>\n";
  page += "<ul>\n";
  for (std::size_t i = 0; i < std::min(report.findings.size(), kMostFindings); ++i)
    page += "<li>" + escape_html(describe(report.findings[i])) + "</li>\n";
  if (report.findings.size() > kMostFindings)
    page += "<li>and " + std::to_string(report.findings.size() - kMostFindings) + " more</li>\n";
  page += "</ul>\n";
  for (std::size_t i = 0; i < std::min(report.pictures.size(), kMostPictures); ++i)
    add_picture(report.pictures[i], page);
  if (report.pictures.size() > kMostPictures)
    page += "<p>and " + std::to_string(report.pictures.size() - kMostPictures) +
            " more pictures, beside this page</p>\n";
  return page + "</html>\n";
}

}  // namespace hydroscope
