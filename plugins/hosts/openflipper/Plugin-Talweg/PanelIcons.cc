#include "PanelIcons.hh"

#include <QApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPixmap>

namespace talweg::openflipper {
namespace {

QPainterPath polygon(std::initializer_list<QPointF> points, bool closed = false) {
  QPainterPath path(*points.begin());
  for (const QPointF& point : points) path.lineTo(point);
  if (closed) path.closeSubpath();
  return path;
}

QPainterPath arrow_back(bool forward) {
  QPainterPath path(QPointF(3, 6));
  path.lineTo(9, 6);
  path.cubicTo(15, 6, 15, 13, 9, 13);
  path.lineTo(6, 13);
  path.addPath(polygon({{6, 3}, {3, 6}, {6, 9}}));
  return forward ? QTransform(-1, 0, 0, 1, 16, 0).map(path) : path;
}

/// An arrow at a shelf, into it or out of it.
QPainterPath shelf(bool in) {
  QPainterPath path = polygon({{2, 10}, {2, 14}, {14, 14}, {14, 10}});
  path.addPath(polygon({{8, 2}, {8, 11}}));
  path.addPath(in ? polygon({{5, 8}, {8, 11}, {11, 8}}) : polygon({{5, 5}, {8, 2}, {11, 5}}));
  return path;
}

QPainterPath scissors() {
  QPainterPath path = polygon({{4, 2}, {10, 11}});
  path.addPath(polygon({{12, 2}, {6, 11}}));
  path.addEllipse(QPointF(4.5, 12.5), 2, 2);
  path.addEllipse(QPointF(11.5, 12.5), 2, 2);
  return path;
}

QPainterPath bin() {
  QPainterPath path = polygon({{4, 5}, {5, 14}, {11, 14}, {12, 5}});
  path.addPath(polygon({{2, 4}, {14, 4}}));
  path.addPath(polygon({{6, 4}, {6, 2}, {10, 2}, {10, 4}}));
  return path;
}

QPainterPath loop(bool with_centre) {
  QPainterPath path;
  path.addEllipse(QRectF(2, 3, 12, 10));
  if (with_centre) path.addEllipse(QRectF(6, 6, 4, 4));
  return path;
}

/// A polyline with its corners, for "from other lines".
QPainterPath from() {
  QPainterPath path = polygon({{2, 12}, {6, 5}, {10, 10}, {14, 3}});
  for (const QPointF& corner : {QPointF(2, 12), QPointF(6, 5), QPointF(10, 10), QPointF(14, 3)}) {
    path.addEllipse(corner, 1, 1);
  }
  return path;
}

QPainterPath cross() {
  QPainterPath path = polygon({{3, 3}, {13, 13}});
  path.addPath(polygon({{13, 3}, {3, 13}}));
  return path;
}

QPainterPath parts() {
  QPainterPath path = polygon({{2, 3}, {6, 3}, {4, 13}, {2, 13}}, true);
  path.addPath(polygon({{10, 3}, {14, 3}, {14, 13}, {8, 13}}, true));
  return path;
}

QPainterPath tool() {
  QPainterPath path = polygon({{3, 13}, {9, 7}});
  path.addPath(polygon({{8, 3}, {8, 7}, {9, 8}, {13, 8}}));
  path.addPath(polygon({{10, 2}, {10, 6}, {14, 6}}));
  return path;
}

QPainterPath pin() {
  QPainterPath path = polygon({{8, 9}, {8, 15}});
  path.addPath(polygon({{5, 2}, {11, 2}, {10, 3}, {10, 6}, {12, 9}, {4, 9}, {6, 6}, {6, 3}}, true));
  return path;
}

/// A curve with another curve beside it.
QPainterPath band() {
  QPainterPath path(QPointF(2, 10));
  path.cubicTo(5, 4, 8, 12, 14, 5);
  path.addPath(polygon({{2, 14}, {5, 11}, {9, 13}, {14, 10}}));
  return path;
}

QPainterPath path_of(Sign sign) {
  switch (sign) {
    case Sign::kPencil:
      return polygon({{2, 14}, {3, 10}, {11, 2}, {14, 5}, {6, 13}}, true);
    case Sign::kTick:
      return polygon({{2, 8}, {6, 13}, {14, 3}});
    case Sign::kLoop:
      return loop(false);
    case Sign::kBack:
      return arrow_back(false);
    case Sign::kForward:
      return arrow_back(true);
    case Sign::kCross:
      return cross();
    case Sign::kBin:
      return bin();
    case Sign::kFrom:
      return from();
    case Sign::kRead:
      return shelf(false);
    case Sign::kWrite:
      return shelf(true);
    case Sign::kScissors:
      return scissors();
    case Sign::kParts:
      return parts();
    case Sign::kInside:
      return loop(true);
    case Sign::kTool:
      return tool();
    case Sign::kPin:
      return pin();
    case Sign::kOffset:
      return band();
  }
  return {};
}

QPixmap drawn(const QPainterPath& path, const QColor& colour) {
  constexpr int kScale = 2;  // icons are drawn larger, for screens with small pixels
  QPixmap pixmap(16 * kScale, 16 * kScale);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(kScale, kScale);
  painter.setPen(QPen(colour, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  return pixmap;
}

}  // namespace

QIcon icon_of(Sign sign) {
  const QPainterPath path = path_of(sign);
  const QPalette palette = QApplication::palette();
  QIcon icon;
  icon.addPixmap(drawn(path, palette.color(QPalette::Active, QPalette::ButtonText)));
  icon.addPixmap(drawn(path, palette.color(QPalette::Disabled, QPalette::ButtonText)),
                 QIcon::Disabled);
  return icon;
}

}  // namespace talweg::openflipper
