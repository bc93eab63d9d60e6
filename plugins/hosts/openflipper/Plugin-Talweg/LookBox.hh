// The part of the panel for the looks of curves: colours with their legend, combs, and the mark.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QWidget>

#include "Legend.hh"

namespace talweg::openflipper {

struct LookState {
  int coloured_by = 0;
  double most = 0;     ///< value of the last colour; 0: no colours
  QString unit;        ///< unit of the value
  bool points = true;  ///< whether drawn points are shown
  bool comb = false;
  QString comb_text;  ///< scale of the combs
  int mark = 0;
  QString mark_text;  ///< value and place of the mark
};

class LookBox : public QWidget {
  Q_OBJECT
 public:
  explicit LookBox(QWidget* parent);
  void show_state(const LookState& state);

 signals:
  void colour_by(int what);
  void points(bool with);
  void comb(bool with);
  void mark(int what);

 private:
  QComboBox *colours_, *marks_;
  QCheckBox *points_, *comb_;
  QLabel *comb_text_, *mark_text_;
  Legend* legend_;
};

}  // namespace talweg::openflipper
