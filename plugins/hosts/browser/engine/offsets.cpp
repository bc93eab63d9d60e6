#include "offsets.hpp"

#include <cstdint>

#include "lines.hpp"

namespace talweg::browser {

OffsetWish offset_wish_of(const Json& json) {
  OffsetWish wish;
  wish.curves = json.at("curves").get<std::vector<std::size_t>>();
  wish.distance = json.at("distance").get<double>();
  wish.side = json.at("side").get<std::string>();
  wish.caps = json.at("caps").get<std::string>();
  return wish;
}

Offsets::Offsets(const editing::Plugins& plugins, const editing::MeshArrays& mesh,
                 editing::Defects defects, double weld_within)
    : services_("Talweg page", "1"), instance_(plugins.find("talweg.offset"), services_) {
  if (defects == editing::Defects::kRepair) instance_.set("repair", 1.0);
  if (weld_within > 0) instance_.set("repair_weld_tolerance", weld_within);
  editing::set_mesh(instance_, mesh);
  instance_.set("ends", "open");  // smoothed loops are already closed
}

void Offsets::make(const std::vector<host::Curve>& curves, const OffsetWish& wish) {
  clear();
  std::vector<host::Curve> from;
  for (const std::size_t curve : wish.curves) from.push_back(curves.at(curve));
  instance_.set_curves(editing::courses(from));
  instance_.set("distance", wish.distance);
  instance_.set("side", wish.side);
  instance_.set("caps", wish.caps);
  results_ = instance_.run();
}

Answer Offsets::told() const {
  Answer answer;
  Json lines = drawn_lines(results_.curves, answer);
  Json sides = Json::array();
  for (std::size_t c = 0; c < lines.size(); ++c) {
    const auto curve = static_cast<std::int64_t>(c);
    // A single curve has its report among the entries for all curves.
    const std::string side = results_.text("side", curve);
    sides.push_back(side.empty() ? results_.text("side", -1) : side);
  }
  const host::ReportEntry* warnings = results_.find("warnings");
  answer.json = {{"curves", std::move(lines)},
                 {"sides", std::move(sides)},
                 {"notes", warnings == nullptr ? std::vector<std::string>() : warnings->texts}};
  return answer;
}

}  // namespace talweg::browser
