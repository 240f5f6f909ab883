// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/image/jpeg_file.h"

#include <jpeglib.h>

#include <array>
#include <cstddef>
#include <cstdio>  // jpeglib.h needs it before
#include <cstdlib>
#include <memory>
#include <vector>

#include "solver/base/error.h"

namespace hydroscope {
namespace {

// Instead of ending the program; throwing through the library's C frames is fine with the unwind tables of
// all Debian libraries.
[[noreturn]] void on_error(j_common_ptr info) {
  std::array<char, JMSG_LENGTH_MAX> message{};
  info->err->format_message(info, message.data());
  throw EnvironmentError(std::string("cannot make a JPEG picture: ") + message.data());
}
void on_message(j_common_ptr) {}

struct Compressor {
  Compressor() {
    info.err = jpeg_std_error(&errors);
    errors.error_exit = on_error;
    errors.output_message = on_message;
    jpeg_create_compress(&info);
  }
  ~Compressor() {
    jpeg_destroy_compress(&info);
    std::free(bytes);
  }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  unsigned char* bytes = nullptr;  // the library's, by malloc
  unsigned long size = 0;
};

}  // namespace

std::string make_jpeg(const Image& image, int quality) {
  require(image.width > 0 && image.height > 0, "an image has at least one pixel");
  require(image.rgba.size() ==
              4u * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
          "an image has four bytes a pixel");
  require(quality >= 1 && quality <= 100, "the quality of a JPEG picture lies between 1 and 100");
  Compressor jpeg;
  jpeg_mem_dest(&jpeg.info, &jpeg.bytes, &jpeg.size);
  jpeg.info.image_width = static_cast<JDIMENSION>(image.width);
  jpeg.info.image_height = static_cast<JDIMENSION>(image.height);
  jpeg.info.input_components = 4;
  jpeg.info.in_color_space = JCS_EXT_RGBX;
  jpeg_set_defaults(&jpeg.info);
  jpeg_set_quality(&jpeg.info, quality, TRUE);
  jpeg.info.dct_method = JDCT_ISLOW;
  // Thin lines and letters keep their colour: no colour is shared between neighbouring pixels.
  if (quality >= 80) jpeg.info.comp_info[0].h_samp_factor = jpeg.info.comp_info[0].v_samp_factor = 1;
  jpeg_start_compress(&jpeg.info, TRUE);
  for (int y = 0; y < image.height; ++y) {
    JSAMPROW row = const_cast<JSAMPROW>(image.pixel(0, y));
    jpeg_write_scanlines(&jpeg.info, &row, 1);
  }
  jpeg_finish_compress(&jpeg.info);
  return std::string(reinterpret_cast<const char*>(jpeg.bytes), jpeg.size);
}

}  // namespace hydroscope
