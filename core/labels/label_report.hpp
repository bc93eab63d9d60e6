// A label report tells what smoothing did to the borders and regions of a segmentation.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "talweg/core/labels/label_network.hpp"
#include "talweg/core/measure/report_entry.hpp"
#include "talweg/core/mesh/mesh_attributes.hpp"

namespace talweg {

using LabelNames = std::map<std::int64_t, std::string>;  ///< of labels that have one

/// A sentence for each region that smoothing would have lost or torn apart. All functions here are
/// O(regions + borders), log for names.
std::vector<std::string> warnings_of(const LabelNetwork& network, const LabelNames& names = {});

/// The totals as of any smoothing, with these warnings; what was done to the network, and every
/// region and border ("regions.0.label", "borders.0.left").
std::vector<ReportEntry> entries_of(const LabelNetwork& network,
                                    const std::vector<std::string>& warnings,
                                    const LabelNames& names = {});
/// The report on each border.
std::vector<std::vector<ReportEntry>> curve_entries_of(const LabelNetwork& network);

/// Labels of faces or vertices as an attribute named "label", of whole numbers if they fit.
AttributeColumn label_column(std::span<const std::int64_t> labels);

}  // namespace talweg
