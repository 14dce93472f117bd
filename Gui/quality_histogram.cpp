#include "quality_histogram.h"

#include <QPainter>

#include <algorithm>
#include <utility>

namespace mesher::gui {

namespace {

constexpr double kStraight = 180.0;  // degrees
// Below and above these the condition of the elements' stiffness grows fast.
constexpr double kSmallAngle = 10.0;
constexpr double kLargeAngle = 165.0;

}  // namespace

QualityHistogram::QualityHistogram(QWidget* parent) : QWidget(parent)
{
    setObjectName(QStringLiteral("histogram"));
}

void QualityHistogram::setCounts(QVector<double> counts)
{
    counts_ = std::move(counts);
    update();
}

QSize QualityHistogram::sizeHint() const { return {220, 90}; }
QSize QualityHistogram::minimumSizeHint() const { return {120, 60}; }

void QualityHistogram::paintEvent(QPaintEvent*)
{
    if (counts_.isEmpty()) return;
    QPainter painter(this);
    const int textHeight = fontMetrics().height();
    const QRectF area(0.5, 2.5, width() - 1.0, height() - textHeight - 4.0);
    const double largest = std::max(1.0, *std::max_element(counts_.begin(), counts_.end()));
    const int count = static_cast<int>(counts_.size());
    const double barWidth = area.width() / count;
    for (int i = 0; i < count; ++i) {
        if (counts_[i] <= 0.0) continue;
        const double from = kStraight * i / count;
        const double to = kStraight * (i + 1) / count;
        const bool isBad = to <= kSmallAngle || from >= kLargeAngle;
        // A class with one element in a million is what one looks for: it never vanishes.
        const double barHeight = std::max(2.0, area.height() * counts_[i] / largest);
        painter.fillRect(
            QRectF(area.left() + i * barWidth + 0.5, area.bottom() - barHeight, barWidth - 1.0, barHeight),
            isBad ? QColor(200, 60, 50) : QColor(74, 128, 190));
    }
    painter.setPen(palette().color(QPalette::Mid));
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    painter.setPen(palette().color(QPalette::Text));
    const QRectF labels(0.0, area.bottom() + 1.0, width(), textHeight);
    painter.drawText(labels, Qt::AlignLeft, tr("0\u00b0"));
    painter.drawText(labels, Qt::AlignHCenter, tr("90\u00b0"));
    painter.drawText(labels, Qt::AlignRight, tr("180\u00b0"));
}

}  // namespace mesher::gui
