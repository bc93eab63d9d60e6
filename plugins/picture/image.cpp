#include "picture/image.hpp"

#include <string>

#include <png.h>

#include "talweg/core/formats/file_bytes.hpp"

namespace talweg::picture {

void write_png(const std::filesystem::path& path, const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  // Into memory first, so that the file is the old or the whole new picture.
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) ==
      0) {
    cannot_write(path, header.message);
  }
  bytes.resize(size);
  write_file(path, bytes);
}

}  // namespace talweg::picture
