#pragma once

#include <QVector>
#include <QWidget>

namespace mesher::gui {

/// How many angles of a mesh lie in each of equal classes from 0 to 180 degrees, as bars; the classes at which solvers begin
/// to suffer are marked by colour.
class QualityHistogram : public QWidget
{
    Q_OBJECT

public:
    explicit QualityHistogram(QWidget* parent = nullptr);

    void setCounts(QVector<double> counts);
    [[nodiscard]] const QVector<double>& counts() const { return counts_; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QVector<double> counts_;
};

}  // namespace mesher::gui
