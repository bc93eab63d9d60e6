#include "EditNames.hh"

#include <QCoreApplication>
#include <algorithm>
#include <iterator>

namespace talweg::openflipper {
namespace {

const char* const kNames[] = {QT_TRANSLATE_NOOP("Edits", "Add curve"),
                              QT_TRANSLATE_NOOP("Edits", "Add curves"),
                              QT_TRANSLATE_NOOP("Edits", "Add point"),
                              QT_TRANSLATE_NOOP("Edits", "Click distance"),
                              QT_TRANSLATE_NOOP("Edits", "Close curve"),
                              QT_TRANSLATE_NOOP("Edits", "Continue curve"),
                              QT_TRANSLATE_NOOP("Edits", "Curves from faces"),
                              QT_TRANSLATE_NOOP("Edits", "Curves from selection"),
                              QT_TRANSLATE_NOOP("Edits", "Cut"),
                              QT_TRANSLATE_NOOP("Edits", "Draw"),
                              QT_TRANSLATE_NOOP("Edits", "Drop curve"),
                              QT_TRANSLATE_NOOP("Edits", "Ends"),
                              QT_TRANSLATE_NOOP("Edits", "Finish curve"),
                              QT_TRANSLATE_NOOP("Edits", "Insert point"),
                              QT_TRANSLATE_NOOP("Edits", "Kind of ridges"),
                              QT_TRANSLATE_NOOP("Edits", "Largest deviation"),
                              QT_TRANSLATE_NOOP("Edits", "Move point"),
                              QT_TRANSLATE_NOOP("Edits", "Open curve"),
                              QT_TRANSLATE_NOOP("Edits", "Pin curve"),
                              QT_TRANSLATE_NOOP("Edits", "Pin point"),
                              QT_TRANSLATE_NOOP("Edits", "Remove all curves"),
                              QT_TRANSLATE_NOOP("Edits", "Remove curve"),
                              QT_TRANSLATE_NOOP("Edits", "Remove point"),
                              QT_TRANSLATE_NOOP("Edits", "Rename curve"),
                              QT_TRANSLATE_NOOP("Edits", "Reverse curve"),
                              QT_TRANSLATE_NOOP("Edits", "Slack"),
                              QT_TRANSLATE_NOOP("Edits", "Snap to ridges"),
                              QT_TRANSLATE_NOOP("Edits", "Take back point"),
                              QT_TRANSLATE_NOOP("Edits", "Tau"),
                              QT_TRANSLATE_NOOP("Edits", "Tau of curve"),
                              QT_TRANSLATE_NOOP("Edits", "Tolerance of curve"),
                              QT_TRANSLATE_NOOP("Edits", "Unpin curve"),
                              QT_TRANSLATE_NOOP("Edits", "Unpin point")};

}  // namespace

QString name_of_edit(const std::string& name) {
  const auto* const known = std::find(std::begin(kNames), std::end(kNames), name);
  return known == std::end(kNames) ? QString::fromStdString(name)
                                   : QCoreApplication::translate("Edits", *known);
}

}  // namespace talweg::openflipper
