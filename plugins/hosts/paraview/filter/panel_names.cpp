#include "panel_names.hpp"

#include <cctype>

namespace talweg::paraview {
namespace {

bool is_of_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Replaces whole words of a text.
void replace(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at)) {
    const std::size_t end = at + what.size();
    const bool begins = at == 0 || !is_of_word(text[at - 1]);
    const bool ends = end == text.size() || !is_of_word(text[end]) || !is_of_word(what.back());
    if (begins && ends) text.replace(at, what.size(), by);
    at += begins && ends ? by.size() : what.size();
  }
}

}  // namespace

std::string property_name(std::string_view id) {
  if (id == "points") return "DrawnPoints";
  std::string result;
  bool first = true;
  for (const char c : id) {
    if (c != '_') {
      result += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    first = c == '_';
  }
  return result;
}

std::string panel_name(std::string_view id) {
  std::string result;
  for (const char c : property_name(id)) {
    if (!result.empty() && std::isupper(static_cast<unsigned char>(c)) != 0) result += ' ';
    result += c;
  }
  return result;
}

std::string in_words_of_panel(std::string sentence, const talweg_plugin& plugin) {
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const talweg_parameter& parameter = *plugin.parameters[k];
    const std::string_view id = parameter.id;
    const std::string name = panel_name(id);
    replace(sentence, std::string(parameter.label) + " (" + parameter.id + ")", name);
    if (id.find('_') != std::string_view::npos) replace(sentence, id, name);
  }
  return sentence;
}

}  // namespace talweg::paraview
