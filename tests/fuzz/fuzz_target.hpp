// A fuzz target is what bytes are given to. A target returns for good and for bad input alike; it
// aborts where a promise is broken or an input is slow for its size, and the sanitizers where
// memory is broken.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::fuzz {

struct Target {
  std::string name;  ///< as of the folders with its inputs
  void (*run)(const Target& target, const std::uint8_t* data, std::size_t size);
  std::vector<std::string> (*seeds)(const Target& target);  ///< small inputs to start from
  std::string file;  ///< for readers: a name with the format's extension
  double median;     ///< of the costs of its corpus: blocks per byte, see CostLimit
};

/// All but the plugin interface's, which needs plugins.
const std::vector<Target>& targets();
/// nullptr where there is none of this name.
const Target* target_named(std::string_view name);
/// Gives the bytes to the target, within its CostLimit; the blocks that it ran.
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
/// Random bytes, a few lengths.
std::vector<std::string> random_seeds(const Target& target);

}  // namespace talweg::fuzz
