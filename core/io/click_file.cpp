#include "talweg/core/io/click_file.hpp"

#include <utility>

#include "talweg/core/io/curve_file.hpp"
#include "talweg/core/io/curve_formats.hpp"
#include "talweg/core/io/file_bytes.hpp"
#include "talweg/core/io/json_place.hpp"
#include "talweg/core/io/mesh_file.hpp"
#include "talweg/core/io/text_encoding.hpp"

namespace talweg {
namespace {

void check_click_name(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".fcsv" || extension == ".json") return;
  cannot_read(path, "clicks are read from .fcsv and .mrk.json");
}

}  // namespace

CurveInput read_clicks(const std::filesystem::path& path, const CoordinateFrame& frame) {
  check_click_name(path);
  return read_clicks(path, read_file(path), frame);
}

CurveInput read_clicks(const std::filesystem::path& path, std::string_view bytes,
                       const CoordinateFrame& frame) {
  check_click_name(path);
  if (lower_extension(path) == ".fcsv") return std::move(read_curves(path, bytes, frame).front());
  if (bytes.empty()) cannot_read(path, "the file is empty");
  formats::check_encoding(path, bytes);
  const formats::Source source{path, bytes, frame};
  const nlohmann::json document = formats::parsed_json(source);
  return formats::read_slicer_clicks(formats::JsonPlace(path, document, ""), source);
}

}  // namespace talweg
