// The legend says which values the colours in the scene stand for.
#pragma once

#include <QString>
#include <QWidget>

namespace talweg::openflipper {

class Legend : public QWidget {
  Q_OBJECT
 public:
  explicit Legend(QWidget* parent);
  /// Colours go from 0 to `most`; hidden where that is not more than 0.
  void show_scale(double most, const QString& unit);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double most_ = 0;
  QString unit_;
};

}  // namespace talweg::openflipper
