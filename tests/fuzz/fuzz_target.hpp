// A fuzz target is a function that takes arbitrary bytes. A target returns for valid and invalid
// input; it aborts on a broken promise or an input that is slow for its size. The sanitizers abort
// on memory errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::fuzz {

struct Target {
  std::string name;  ///< also the name of the folder of its inputs
  void (*run)(const Target& target, const std::uint8_t* data, std::size_t size);
  std::vector<std::string> (*seeds)(const Target& target);  ///< small inputs to start from
  std::string file;  ///< for readers: a name with the format's extension
  double median;     ///< median cost of its corpus: blocks per byte, see CostLimit
};

/// All targets except the plugin interface, which needs plugins.
const std::vector<Target>& targets();
/// The target with a name; nullptr if there is none.
const Target* target_named(std::string_view name);
/// Runs the target on the bytes, within its CostLimit. Returns the number of blocks run.
std::uint64_t run(const Target& target, const std::uint8_t* data, std::size_t size);

void read_mesh_bytes(const Target& target, const std::uint8_t* data, std::size_t size);
void read_curve_bytes(const Target& target, const std::uint8_t* data, std::size_t size);
void read_click_bytes(const Target& target, const std::uint8_t* data, std::size_t size);
void read_label_bytes(const Target& target, const std::uint8_t* data, std::size_t size);
void read_field_bytes(const Target& target, const std::uint8_t* data, std::size_t size);
void take_in(const Target& target, const std::uint8_t* data, std::size_t size);
void straighten(const Target& target, const std::uint8_t* data, std::size_t size);
void smooth(const Target& target, const std::uint8_t* data, std::size_t size);

std::vector<std::string> mesh_seeds(const Target& target);
std::vector<std::string> curve_seeds(const Target& target);
std::vector<std::string> label_seeds(const Target& target);
/// Random bytes of several lengths.
std::vector<std::string> random_seeds(const Target& target);

}  // namespace talweg::fuzz
