// A report is what is told of the results of a session.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "ResultTable.hh"
#include "talweg/plugin/talweg_host.hpp"

namespace talweg::openflipper {

class Session;

/// As the panel writes it.
QString length_unit();
QString curvature_unit();
/// How far result and drawing lie apart, either way; `curve` -1: of all curves.
QString farthest_apart(const host::Results& results, int curve);
/// The warnings by which the result may be of no use.
QStringList decisive_sentences(const host::Results& results, int curve);
/// A line for the log.
QString short_report(const Session& session);
/// What the panel shows of the results: the numbers, a line, with which settings, and the warnings.
std::vector<ResultRow> result_rows(const Session& session);
QString result_summary(const Session& session);
QString result_settings(const Session& session);
QStringList result_notes(const Session& session);
/// Everything that was measured, "key = value" or "curve.key = value", one a line.
QString whole_report(const Session& session);

}  // namespace talweg::openflipper
