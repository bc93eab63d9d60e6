// Reads lists of numbers that a user types, separated by spaces or commas.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::paraview {

/// Whole numbers >= 0. Throws std::runtime_error that quotes a wrong word; `what` is the name of
/// the list.
std::vector<std::uint32_t> vertex_numbers(const std::string& text, std::string_view what);

/// Real numbers. Throws as vertex_numbers() does.
std::vector<double> numbers(const std::string& text, std::string_view what);

}  // namespace talweg::paraview
