// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hydroscope {

/// A file of the folder page/, which is built into the program (embed_page.cmake).
struct PageFile {
  std::string_view name;  ///< "index.html"
  std::string_view bytes;
};

const std::vector<PageFile>& page_files();
/// Null when there is none of this name.
const PageFile* find_page_file(const std::string& name);
/// "text/javascript; charset=utf-8" ...
const char* find_page_type(std::string_view name);

}  // namespace hydroscope
