// The part of the panel with the curves: their list, and the commands for the selected curve.
#pragma once

#include <QGroupBox>
#include <QToolButton>
#include <optional>
#include <vector>

#include "CurveTable.hh"
#include "NumberRow.hh"

namespace talweg::openflipper {

struct CurvesState {
  std::vector<CurveRow> rows;
  std::uint32_t selected = 0;  ///< number of a curve; 0: none
  bool unfinished = false;     ///< whether a curve is being drawn
  // State of the selected curve.
  bool closed = false, pinned = false;
  std::optional<double> tau, tolerance;  ///< own values of the selected curve
  double general_tau = 1, general_tolerance = 0;
  double most = 1;  ///< the largest tolerance that the slider offers, mesh units
};

class CurvesBox : public QGroupBox {
  Q_OBJECT
 public:
  explicit CurvesBox(QWidget* parent);
  void show_state(const CurvesState& state);

 signals:
  void read();
  void write();
  void clear();
  void selected(unsigned number);
  void renamed(unsigned number, const QString& name);
  // About the selected curve.
  void remove();
  void pin(bool pinned);
  void set_closed(bool closed);
  void go_on();
  void gesture_begun(const QString& name);
  void gesture_ended();
  void tau_changed(bool set, double tau);
  void tolerance_changed(bool set, double tolerance);

 private:
  void make_numbers(QGridLayout* grid);

  CurveTable* table_;
  QToolButton *write_, *clear_, *remove_, *pin_, *closed_, *go_on_;
  NumberRow *tau_ = nullptr, *tolerance_ = nullptr;
};

}  // namespace talweg::openflipper
