#include "vtkTalwegRun.h"

#include <sstream>
#include <stdexcept>

#include <vtkObjectFactory.h>

#include "number_list.hpp"
#include "property_text.hpp"
#include "session.hpp"

using talweg::paraview::text_of;

vtkStandardNewMacro(vtkTalwegRun);

vtkTalwegRun::vtkTalwegRun() : vtkTalwegCut("talweg.cut") {}

void vtkTalwegRun::SetPlugin(const char* id) { this->Change(this->Plugin, id); }
void vtkTalwegRun::SetParameters(const char* text) { this->Change(this->Parameters, text); }

void vtkTalwegRun::Change(std::string& member, const char* text) {
  if (member == text_of(text)) return;
  member = text_of(text);
  this->Changed = true;
  this->Modified();
}

namespace {

void check_makes_meshes(const talweg_plugin& plugin) {
  for (std::uint32_t k = 0; k < plugin.output_count; ++k) {
    if (plugin.outputs[k]->kind == TALWEG_OUTPUT_MESH) return;
  }
  throw std::runtime_error(std::string(plugin.id) + " makes no meshes.");
}

/// Sets a parameter from a word such as share=0.1.
void set_parameter(const std::string& word, const talweg_plugin& plugin,
                   talweg::paraview::Session& session) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos) {
    throw std::runtime_error("Parameters: '" + word +
                             "' is not of the form NAME=VALUE, such as share=0.1.");
  }
  const std::string id = word.substr(0, equals);
  const std::string value = word.substr(equals + 1);
  for (std::uint32_t k = 0; k < plugin.parameter_count; ++k) {
    const talweg_parameter& parameter = *plugin.parameters[k];
    if (id != parameter.id) continue;
    if (parameter.type == TALWEG_CHOICE) {
      session.set(id, talweg::paraview::Choice{value});
    } else if (parameter.type <= TALWEG_BOOLEAN) {
      const std::vector<double> numbers = talweg::paraview::numbers(value, parameter.label);
      if (numbers.size() != 1) throw std::runtime_error("Parameters: " + id + " needs one number.");
      session.set(id, numbers[0]);
    } else {
      throw std::runtime_error("Parameters: " + id + " is an array, which this filter cannot set.");
    }
    return;
  }
  throw std::runtime_error(std::string(plugin.id) + " has no parameter " + id + ".");
}

}  // namespace

void vtkTalwegRun::Begin() {
  talweg::paraview::Session& session = this->GetSession();
  session.use(this->Plugin);
  const talweg_plugin& plugin = session.instance().plugin();
  check_makes_meshes(plugin);
  std::istringstream words(this->Parameters);
  for (std::string word; words >> word;) set_parameter(word, plugin, session);
  this->Changed = false;
}

void vtkTalwegRun::WorkOn(vtkDataObject& mesh, vtkDataObject* curves, vtkDataObject* others,
                          vtkInformationVector& outputs) {
  if (this->Changed) this->Begin();
  this->Superclass::WorkOn(mesh, curves, others, outputs);
}
