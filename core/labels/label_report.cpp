#include "talweg/core/labels/label_report.hpp"

#include <cstddef>

#include <fmt/format.h>

#include "talweg/core/measure/report.hpp"

namespace talweg {
namespace {

/// Adds an empty array, which has no entries of elements.
void add_if_empty(std::vector<ReportEntry>& entries, const char* key, std::size_t count) {
  if (count == 0) entries.push_back({key, std::vector<double>{}});
}

void add_network(std::vector<ReportEntry>& entries, const LabelNetwork& network) {
  append(entries, "network.",
         {{"borders", std::uint64_t{network.borders.size()}},
          {"junctions", std::uint64_t{network.junctions}},
          {"tightened", std::uint64_t{network.tightened}},
          {"as_drawn", std::uint64_t{network.as_drawn}},
          {"moved", std::uint64_t{network.moved}},
          {"imbalance_before", network.imbalance_before},
          {"imbalance_after", network.imbalance_after}});
}

void add_regions(std::vector<ReportEntry>& entries, const LabelNetwork& network,
                 const LabelNames& names) {
  add_if_empty(entries, "regions", network.regions.size());
  for (std::size_t k = 0; k < network.regions.size(); ++k) {
    const LabelRegion& r = network.regions[k];
    const std::string group = fmt::format("regions.{}.", k);
    append(entries, group,
           {{"label", r.label},
            {"parts_before", std::uint64_t{r.parts_before}},
            {"parts_after", std::uint64_t{r.parts_after}},
            {"area_before", r.area_before},
            {"area_after", r.area_after},
            {"held", r.held}});
    if (const auto name = names.find(r.label); name != names.end()) {
      entries.push_back({group + "name", name->second});
    }
  }
}

void add_borders(std::vector<ReportEntry>& entries, const LabelNetwork& network) {
  add_if_empty(entries, "borders", network.borders.size());
  for (std::size_t k = 0; k < network.borders.size(); ++k) {
    const SmoothedBorder& b = network.borders[k];
    append(entries, fmt::format("borders.{}.", k),
           {{"left", b.border.labels[0]},
            {"right", b.border.labels[1]},
            {"closed", b.border.curve.closed},
            {"as_drawn", b.as_drawn},
            {"tau", b.report.tau},
            {"slack", b.report.slack},
            {"length", b.report.after.length},
            {"curvature_before", b.report.before.total_curvature},
            {"curvature_after", b.report.after.total_curvature}});
  }
}

}  // namespace

std::vector<std::string> warnings_of(const LabelNetwork& network, const LabelNames& names) {
  std::vector<std::string> warnings;
  for (const LabelRegion& region : network.regions) {
    if (!region.held) continue;
    const auto found = names.find(region.label);
    const std::string name = found == names.end() ? "" : found->second;
    warnings.push_back(
        fmt::format("Region {}{} is too small or too thin for this tolerance: some of its borders "
                    "are kept closer to the given ones.",
                    region.label, name.empty() ? "" : " (" + name + ")"));
  }
  return warnings;
}

std::vector<ReportEntry> entries_of(const LabelNetwork& network,
                                    const std::vector<std::string>& warnings,
                                    const LabelNames& names) {
  std::vector<ReportEntry> entries = entries_of(network.total);
  for (ReportEntry& entry : entries) {
    if (entry.key == "warnings") entry.value = warnings;
  }
  add_network(entries, network);
  add_regions(entries, network, names);
  add_borders(entries, network);
  return entries;
}

std::vector<std::vector<ReportEntry>> curve_entries_of(const LabelNetwork& network) {
  std::vector<std::vector<ReportEntry>> all;
  for (const SmoothedBorder& border : network.borders) all.push_back(entries_of(border.report));
  return all;
}

AttributeColumn label_column(std::span<const std::int64_t> labels) {
  AttributeColumn column;
  column.name = "label";
  column.type = NumberType::kInt32;
  for (const std::int64_t label : labels) {
    if (label != static_cast<std::int32_t>(label)) column.type = NumberType::kFloat64;
    column.values.push_back(static_cast<double>(label));
  }
  return column;
}

}  // namespace talweg
