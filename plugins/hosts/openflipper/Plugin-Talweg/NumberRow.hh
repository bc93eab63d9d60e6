// A number row is a setting in the panel: tick or label, slider, box, unit.
#pragma once

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QObject>
#include <QSlider>
#include <optional>

namespace talweg::openflipper {

/// A number with four significant digits, and no exponent.
class SignificantBox : public QDoubleSpinBox {
 public:
  explicit SignificantBox(QWidget* parent);
  [[nodiscard]] QString textFromValue(double value) const override;
};

class NumberRow : public QObject {
  Q_OBJECT
 public:
  struct Texts {
    QString name;  ///< of the widgets, which get "Slider", "Box" and "Tick" behind it
    QString label, tip, unit;
    double most = 1e9;  ///< that the box takes
  };
  /// Takes the next row of the grid, so that sliders of several rows begin and end together. Slider
  /// positions are spaced by the square, so that small values have room. `optional`: with a tick.
  NumberRow(const Texts& texts, double largest, bool optional, QGridLayout* grid, QWidget* parent);
  /// Without signals. What is not set shows `otherwise`, which a tick then sets. `largest` > 0 is
  /// the slider's range.
  void show_value(std::optional<double> value, double otherwise, double largest = 0);
  /// Can be used unless there is a sentence on why not, which is then the tip.
  void show_use(const QString& why_not);

 signals:
  void begun();  ///< the slider is held
  void ended();  ///< and let go
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
  double shown_ = 0;  // what the box was told, without its digits
  bool set_ = true, usable_ = true;
};

}  // namespace talweg::openflipper
