// Lists of numbers as a user types them, separated by spaces or commas.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace talweg::paraview {

/// Numbers from 0. Throws std::runtime_error that quotes what is none; `what` is the name of the
/// list.
std::vector<std::uint32_t> vertex_numbers(const std::string& text, const char* what);

/// Numbers with or without fractions. Throws as vertex_numbers() does.
std::vector<double> numbers(const std::string& text, const char* what);

}  // namespace talweg::paraview
