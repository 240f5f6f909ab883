// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/server/page_files.h"

#include <algorithm>

namespace hydroscope {

const PageFile* find_page_file(const std::string& name) {
  const std::vector<PageFile>& files = page_files();
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const PageFile& file) { return file.name == name; });
  return found == files.end() ? nullptr : &*found;
}

const char* find_page_type(std::string_view name) {
  if (name.ends_with(".html")) return "text/html; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (name.ends_with(".svg")) return "image/svg+xml";
  return "application/octet-stream";
}

}  // namespace hydroscope
