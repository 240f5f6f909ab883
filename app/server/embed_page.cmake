# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DOUTPUT=FILE.cpp -P embed_page.cmake FILE...: the files' bytes as C++, for page_files.h.
cmake_minimum_required(VERSION 3.25)
set(files "")
set(last "")
foreach(index RANGE ${CMAKE_ARGC})
  if(last STREQUAL "--")
    list(APPEND files "${CMAKE_ARGV${index}}")
  elseif("${CMAKE_ARGV${index}}" STREQUAL "--")
    set(last "--")
  endif()
endforeach()

set(arrays "")
set(entries "")
set(number 0)
foreach(file IN LISTS files)
  if(file STREQUAL "")
    continue()
  endif()
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" hex HEX)
  string(REGEX REPLACE "(..)" "0x\\1," bytes "${hex}")
  string(APPEND arrays "const unsigned char kBytes${number}[] = {${bytes}0};\n")
  string(APPEND entries "      {\"${name}\", make_view(kBytes${number}, sizeof kBytes${number})},\n")
  math(EXPR number "${number} + 1")
endforeach()

set(text "// Made by embed_page.cmake.
#include \"app/server/page_files.h\"

namespace hydroscope {
namespace {

${arrays}
/// Without the zero at the end.
std::string_view make_view(const unsigned char* bytes, std::size_t size) {
  return {reinterpret_cast<const char*>(bytes), size - 1};
}

}  // namespace

const std::vector<PageFile>& page_files() {
  static const std::vector<PageFile> files = {
${entries}  };
  return files;
}

}  // namespace hydroscope
")
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "@text@" @ONLY)
