#include "talweg/core/io/space_note.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "talweg/core/io/text_words.hpp"

namespace talweg::formats {
namespace {

constexpr std::string_view kTag = "SPACE=";

std::string file_name(const std::filesystem::path& path) {
  return printable(path.filename().string());
}

}  // namespace

PatientSpace space_in(std::string_view comment) {
  for (std::size_t at = comment.find(kTag); at != comment.npos; at = comment.find(kTag, at + 1)) {
    const std::string_view name = comment.substr(at + kTag.size(), 3);
    const std::string_view after = comment.substr(at + kTag.size()).substr(name.size());
    const bool ends = after.empty() || is_blank(after[0]) || after[0] == '\0' || after[0] == '\n';
    if (!ends) continue;
    if (name == "LPS") return PatientSpace::kLps;
    if (name == "RAS") return PatientSpace::kRas;
  }
  return PatientSpace::kNotSaid;
}

PatientSpace space_in_comments(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    const std::size_t first = line.find_first_not_of(" \t\r");
    if (first != line.npos && line[first] != '#') break;
    const PatientSpace space = space_in(line);
    if (space != PatientSpace::kNotSaid) return space;
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return PatientSpace::kNotSaid;
}

std::string space_line(std::string_view prefix, PatientSpace space) {
  if (space == PatientSpace::kNotSaid) return {};
  return fmt::format("{}{}{}\n", prefix, kTag, space_name(space));
}

std::string space_data(PatientSpace space) {
  if (space == PatientSpace::kNotSaid) return {};
  std::string codes;
  for (const char letter : space_name(space)) codes += fmt::format("{} ", int{letter});
  return fmt::format(
      "<FieldData>\n<Array type=\"String\" Name=\"SPACE\" NumberOfTuples=\"1\" "
      "format=\"ascii\">\n{}0\n</Array>\n</FieldData>\n",
      codes);
}

void turn_to(const CoordinateFrame& frame, PatientSpace space, const std::filesystem::path& path,
             std::vector<CurveInput>& curves) {
  if (!frame.turns(space)) return;
  for (CurveInput& curve : curves) {
    auto* positions = std::get_if<std::vector<Point>>(&curve.points);
    if (positions == nullptr) continue;
    for (Point& p : *positions) p = Point(-p.x(), -p.y(), p.z());
  }
  if (!curves.empty()) {
    curves.front().notes.push_back(conversion(path, {frame.unit, space}, frame));
  }
}

std::string conversion(const std::filesystem::path& path, const CoordinateFrame& from,
                       const CoordinateFrame& to) {
  std::string done, why;
  if (to.turns(from.space)) {
    const bool said = to.space != PatientSpace::kNotSaid;
    done = fmt::format("turned from {} to {} (x and y change their sign)", space_name(from.space),
                       said ? space_name(to.space) : "LPS");
    if (!said) why = ", since a mesh that names no space is taken to be in LPS";
  }
  const double scale = from.unit.in(to.unit);
  if (scale != 1) {
    done += fmt::format("{}scaled by {:.6g} from {} to {}", done.empty() ? "" : " and ", scale,
                        from.unit.code(), to.unit.code());
  }
  if (done.empty()) return done;
  return fmt::format("The positions of {} were {}{}.", file_name(path), done, why);
}

std::string left_out(const std::filesystem::path& path, std::size_t count, std::size_t all) {
  return fmt::format("{} of {} points of {} {} no position and {} left out.", count, all,
                     file_name(path), count == 1 ? "has" : "have", count == 1 ? "was" : "were");
}

}  // namespace talweg::formats
