#include "tools/picture/image.hpp"

#include <string>

#include <png.h>

#include "talweg/core/io/file_bytes.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg::picture {

std::string png_bytes(const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    throw Error(ErrorCode::kBadFile,
                std::string("No picture can be made: ") + header.message + ".");
  }
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  // The bytes are made in memory first, so that the file is the old or the whole new picture.
  write_file(path, png_bytes(image));
}

}  // namespace talweg::picture
