// A row of the panel for a number: a tick or label, a slider, a box, and a unit.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QObject>
#include <QSlider>
#include <optional>

namespace talweg::openflipper {

/// A box for a number with four significant digits and without an exponent.
class SignificantBox : public QDoubleSpinBox {
 public:
  explicit SignificantBox(QWidget* parent);
  [[nodiscard]] QString textFromValue(double value) const override;
};

class NumberRow : public QObject {
  Q_OBJECT
 public:
  struct Texts {
    QString name;  ///< prefix of the widgets' names: "Slider", "Box" and "Tick" follow
    QString label, tip, unit;
    double most = 1e9;  ///< that the box takes
  };
  /// Takes the next row of the grid, so that sliders of several rows are aligned. The value grows
  /// with the square of the slider's position, which leaves room for small values. `optional`: with
  /// a tick.
  NumberRow(const Texts& texts, double largest, bool optional, QGridLayout* grid, QWidget* parent);
  /// Shows a value without signals. Without a value the row shows `otherwise`, which a tick then
  /// sets. `largest` > 0 is the end of the slider.
  void show_value(std::optional<double> value, double otherwise, double largest = 0);
  /// Disables the row if `why_not` has a sentence, which becomes its tip.
  void show_use(const QString& why_not);

 signals:
  void begun();  ///< the slider is pressed
  void ended();  ///< the slider is released
  void changed(bool set, double value);

 private:
  void enable();
  [[nodiscard]] double value_at(int position) const;
  [[nodiscard]] int position_of(double value) const;

  QWidget* head_;
  QCheckBox* tick_ = nullptr;
  QSlider* slider_;
  QDoubleSpinBox* box_;
  QLabel* unit_;
  QString tip_;
  double largest_;
  double shown_ = 0;  // the value given to the box, before rounding to its digits
  bool set_ = true, usable_ = true;
};

}  // namespace talweg::openflipper
