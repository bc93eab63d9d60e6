#include "property_xml.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "panel_names.hpp"

namespace talweg::paraview {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

namespace {

/// The beginning of a property: its name and its command. Scripts use a property's label as its
/// name, so no label is set: ParaView makes one from the name.
std::string opening(const talweg_parameter& p, const char* kind, const char* command) {
  return fmt::format(
      "<{} name=\"{}\" command=\"{}\" initial_string=\"{}\" number_of_elements=\"1\" "
      "panel_visibility=\"{}\"",
      kind, property_name(p.id), command, p.id,
      (p.flags & TALWEG_ADVANCED) != 0 ? "advanced" : "default");
}

std::string documentation(const talweg_parameter& p, const std::string& more = {}) {
  std::string text = fmt::format("{}. {}", p.label, p.doc);
  if (*p.unit != '\0') text += fmt::format(" In {}.", p.unit);
  return fmt::format("<Documentation>{}</Documentation>", escaped(text + more));
}

/// The range of a slider: lengths depend on the mesh, all other numbers have fixed ranges.
std::string number_domain(const talweg_parameter& p) {
  if (std::string_view(p.unit) != "mesh units") {
    return fmt::format("<DoubleRangeDomain name=\"range\" min=\"{}\" max=\"{}\"/>", p.soft_minimum,
                       p.soft_maximum);
  }
  return "<BoundsDomain name=\"range\" mode=\"scaled_extent\" scale_factor=\"0.05\">"
         "<RequiredProperties><Property name=\"Input\" function=\"Input\"/></RequiredProperties>"
         "</BoundsDomain>";
}

/// The hint with the property that has the value of the last run, for the panel.
std::string in_force(const talweg_parameter& p) {
  if (std::string_view(p.id) == "slack") return "<InForce property=\"SlackUsed\" says=\"used\"/>";
  if (std::string_view(p.id) != "max_deviation") return "";
  return "<InForce property=\"DeviationReached\" says=\"reached\"/>";
}

std::string number_property(const talweg_parameter& p) {
  const bool optional = (p.flags & TALWEG_OPTIONAL) != 0;
  if (optional && p.minimum < 0) {
    throw std::runtime_error(fmt::format("{}: -1 cannot stand for its absence.", p.id));
  }
  // The hint keeps the domain from choosing the default.
  return fmt::format(
      "{}{} default_values=\"{}\">{}{}<Hints><NoDefault/>{}</Hints>"
      "</DoubleVectorProperty>\n",
      opening(p, "DoubleVectorProperty", "SetNumber"),
      optional ? " panel_widget=\"TalwegOptional\"" : "", optional ? -1 : p.default_number,
      number_domain(p), documentation(p, optional ? " Automatic: not given; -1 in scripts." : ""),
      in_force(p));
}

std::string integer_property(const talweg_parameter& p) {
  if ((p.flags & TALWEG_OPTIONAL) != 0)
    return number_property(p);  // Talweg itself refuses
                                // fractions
  return fmt::format(
      "{} default_values=\"{}\">"
      "<IntRangeDomain name=\"range\" min=\"{}\" max=\"{}\"/>{}"
      "</IntVectorProperty>\n",
      opening(p, "IntVectorProperty", "SetNumber"), p.default_number, p.soft_minimum,
      p.soft_maximum, documentation(p));
}

std::string boolean_property(const talweg_parameter& p) {
  return fmt::format(
      "{} default_values=\"{}\"><BooleanDomain name=\"bool\"/>{}"
      "</IntVectorProperty>\n",
      opening(p, "IntVectorProperty", "SetNumber"), p.default_number, documentation(p));
}

std::string choice_property(const talweg_parameter& p) {
  std::string choices;
  std::string labels;
  for (std::uint32_t k = 0; k < p.choice_count; ++k) {
    choices += fmt::format("<String value=\"{}\"/>", escaped(p.choices[k]));
    labels += fmt::format(" {}: {}.", p.choices[k], p.choice_labels[k]);
  }
  return fmt::format(
      "{} default_values=\"{}\"><StringListDomain name=\"choices\">{}"
      "</StringListDomain>{}</StringVectorProperty>\n",
      opening(p, "StringVectorProperty", "SetChoice"), escaped(p.default_choice), choices,
      documentation(p, labels));
}

std::string vertices_property(const talweg_parameter& p) {
  return fmt::format("{} default_values=\"\">{}</StringVectorProperty>\n",
                     opening(p, "StringVectorProperty", "SetVertices"),
                     documentation(p, " Numbers from 0, separated by spaces or commas."));
}

/// A text, since the number of curves is not known before the filter runs. Numbers are in the order
/// of the output's curves, in which lines of the input come before joined segments.
std::string per_curve_property(const talweg_parameter& p) {
  return fmt::format(
      "{} default_values=\"\">{}</StringVectorProperty>\n",
      opening(p, "StringVectorProperty", "SetCurveNumbers"),
      documentation(p,
                    " Numbers in the order of the output's lines, separated by spaces or commas. "
                    "Empty: not given."));
}

std::string field_property(const talweg_parameter& p, const char* command, const char* domain,
                           const char* of) {
  return fmt::format(
      "{} default_values=\"None\"><ArrayListDomain name=\"array_list\" none_string=\"None\" "
      "attribute_type=\"Scalars\" input_domain_name=\"{}\">"
      "<RequiredProperties><Property name=\"Input\" function=\"Input\"/></RequiredProperties>"
      "</ArrayListDomain>{}<Hints><NoDefault/></Hints></StringVectorProperty>\n",
      opening(p, "StringVectorProperty", command), domain,
      documentation(p, fmt::format(" A {} array of the mesh.", of)));
}

}  // namespace

std::string property_xml(const talweg_parameter& p) {
  switch (p.type) {
    case TALWEG_NUMBER:
      return number_property(p);
    case TALWEG_INTEGER:
      return integer_property(p);
    case TALWEG_BOOLEAN:
      return boolean_property(p);
    case TALWEG_CHOICE:
      return choice_property(p);
    case TALWEG_VERTICES:
      return vertices_property(p);
    case TALWEG_FIELD:
      return field_property(p, "SetField", "arrays", "point");
    case TALWEG_TRIANGLE_FIELD:
      return field_property(p, "SetTriangleField", "cell_arrays", "cell");
    case TALWEG_PER_CURVE:
      return per_curve_property(p);
    default:  // a kind of a later version of the interface: the parameter keeps its default
      return "";
  }
}

}  // namespace talweg::paraview
