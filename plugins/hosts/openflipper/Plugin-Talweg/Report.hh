// Texts about the results of a session.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "ResultTable.hh"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::openflipper {

class Session;

/// Units as the panel writes them.
QString length_unit();
QString curvature_unit();
/// The distance between result and drawing, either way; `curve` -1: of all curves.
QString farthest_apart(const host::Results& results, int curve);
/// The decisive warnings, by which the result may be of no use.
QStringList decisive_sentences(const host::Results& results, int curve);
/// A line for the log.
QString short_report(const Session& session);
/// Texts of the panel: the numbers, a line on the result, the settings, and the warnings.
std::vector<ResultRow> result_rows(const Session& session);
QString result_summary(const Session& session);
QString result_settings(const Session& session);
QStringList result_notes(const Session& session);
/// All measures, "key = value" or "curve.key = value", one on each line.
QString whole_report(const Session& session);

}  // namespace talweg::openflipper
