#include "mesh_words.hpp"

#include <cmath>
#include <cstdint>
#include <cstdio>

namespace talweg::browser {
namespace {

/// 1,234,567
std::string grouped(double number) {
  std::string digits = std::to_string(static_cast<std::int64_t>(number));
  for (std::size_t k = digits.size(); k > 3; k -= 3) digits.insert(k - 3, 1, ',');
  return digits;
}

std::string number(double value) {
  if (value >= 999.95 && value < 1e15) return grouped(std::round(value));
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string line(const char* label, const std::string& value) {
  std::string text = label;
  text.resize(18, ' ');
  return text + value + "\n";
}

std::string defects_in(const host::Results& r) {
  const host::ReportEntry* found = r.find("defects_found");
  if (found == nullptr) return "";
  std::string text;
  for (const std::string& defect : found->texts) text.append("  ").append(defect).append("\n");
  return text;
}

std::string extent_in(const host::Results& r) {
  const host::ReportEntry *low = r.find("box_min"), *high = r.find("box_max");
  if (low == nullptr || high == nullptr || low->numbers.size() < 3 || high->numbers.size() < 3) {
    return "unknown";
  }
  std::string text;
  for (std::size_t k = 0; k < 3; ++k) {
    text += (k > 0 ? " x " : "") + number(high->numbers[k] - low->numbers[k]);
  }
  return text;
}

}  // namespace

std::string words_of(const host::Results& r) {
  const double loops = r.number("boundary_loops");
  std::string text =
      line("faces", grouped(r.number("faces"))) + line("vertices", grouped(r.number("vertices"))) +
      line("edges", grouped(r.number("edges"))) + line("parts", grouped(r.number("components"))) +
      line("boundary loops", loops > 0 ? grouped(loops) : "none (closed)") +
      line("size", extent_in(r)) +
      line("edge length", number(r.number("edge_length_mean")) + " (shortest " +
                              number(r.number("edge_length_min")) + ", longest " +
                              number(r.number("edge_length_max")) + ")");
  const std::string defects = defects_in(r);
  if (!defects.empty()) text += "\nFound:\n" + defects;
  return text + "\n" + r.text("reason") + "\n";
}

std::string words_of(const editing::MeshArrays& mesh, double mean_edge) {
  return line("faces", grouped(static_cast<double>(mesh.triangles.size()))) +
         line("vertices", grouped(static_cast<double>(mesh.positions.size()))) +
         line("edge length", number(mean_edge)) + "\nThe command talweg info tells more.\n";
}

}  // namespace talweg::browser
