#include "picture/image.hpp"

#include <png.h>

#include "talweg/intrinsic/error.hpp"

namespace talweg::picture {

void write_png(const std::filesystem::path& path, const Image& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  if (png_image_write_to_file(&header, path.c_str(), 0, image.rgb.data(), 0, nullptr) == 0) {
    throw Error(ErrorCode::kBadFile,
                "cannot write the picture " + path.string() + ": " + header.message);
  }
}

}  // namespace talweg::picture
