// A label report describes the borders and regions of a smoothed segmentation.
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

using LabelNames = std::map<std::int64_t, std::string>;  ///< names of labels, where known

/// A sentence for each region whose borders are held near the drawing. All functions here are
/// O((regions + borders) log names).
std::vector<std::string> warnings_of(const LabelNetwork& network, const LabelNames& names = {});

/// The totals of smoothing, with these warnings; statistics of the network; and every region and
/// border ("regions.0.label", "borders.0.left").
std::vector<ReportEntry> entries_of(const LabelNetwork& network,
                                    const std::vector<std::string>& warnings,
                                    const LabelNames& names = {});
/// The entries of the report of each border.
std::vector<std::vector<ReportEntry>> curve_entries_of(const LabelNetwork& network);

/// Labels of faces or vertices as an attribute named "label", of 32-bit integers if all fit, else
/// of doubles.
AttributeColumn label_column(std::span<const std::int64_t> labels);

}  // namespace talweg
