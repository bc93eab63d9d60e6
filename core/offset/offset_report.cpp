#include "talweg/core/offset/offset_report.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "talweg/core/version.hpp"
#include "talweg/intrinsic/error.hpp"

namespace talweg {
namespace {

std::vector<ReportEntry> places_of(const OffsetCurve& made) {
  return {{"distance", made.distance},
          {"side", std::string(to_string(made.side))},
          {"along", std::uint64_t{made.along}},
          {"closed", made.curve.closed}};
}

}  // namespace

std::vector<ReportEntry> entries_of(const SurfaceMesh& mesh, const OffsetResult& result,
                                    const std::vector<std::string>& warnings) {
  std::uint64_t points = 0;
  double length = 0, off_max = 0;
  for (const OffsetCurve& made : result.curves) {
    points += made.curve.points.size();
    length += made.length;
    off_max = std::max(off_max, made.off_max);
  }
  std::vector<ReportEntry> entries = {{"version", std::string(version())},
                                      {"faces", std::uint64_t{mesh.surface().face_count()}},
                                      {"vertices", std::uint64_t{mesh.surface().vertex_count()}},
                                      {"components", std::uint64_t{result.curves.size()}}};
  if (result.curves.size() == 1) append(entries, "", places_of(result.curves.front()));
  append(entries, "",
         {{"points", points},
          {"length", length},
          {"distance_off_max", off_max},
          {"warnings", warnings}});
  return entries;
}

std::vector<std::vector<ReportEntry>> curve_entries_of(const OffsetResult& result) {
  std::vector<std::vector<ReportEntry>> all;
  for (const OffsetCurve& made : result.curves) {
    all.push_back(places_of(made));
    append(all.back(), "",
           {{"points", std::uint64_t{made.curve.points.size()}},
            {"length", made.length},
            {"distance_off_max", made.off_max}});
  }
  return all;
}

void check_any(const OffsetResult& result) {
  if (!result.curves.empty()) return;
  throw Error(ErrorCode::kBadUsage, fmt::format("{}", fmt::join(result.warnings, " ")));
}

}  // namespace talweg
