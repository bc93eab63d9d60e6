// Lists of numbers as a user types them, separated by spaces or commas.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace talweg::paraview {

/// Numbers from 0. Throws std::runtime_error that quotes what is none; `what` is the name of the
/// list.
std::vector<std::uint32_t> vertex_numbers(const std::string& text, std::string_view what);

/// Numbers with or without fractions. Throws as vertex_numbers() does.
std::vector<double> numbers(const std::string& text, std::string_view what);

}  // namespace talweg::paraview
