#pragma once

#include <QDoubleSpinBox>

namespace mesher::gui {

/// A length in millimetres, which may be typed in another unit: "2 cm", "0.25 in", "500 um". 0 shows as a word.
class LengthBox : public QDoubleSpinBox
{
    Q_OBJECT

public:
    /// `none` is what 0 means.
    explicit LengthBox(const QString& none, QWidget* parent = nullptr);

    [[nodiscard]] QString textFromValue(double value) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QValidator::State validate(QString& text, int& position) const override;
};

}  // namespace mesher::gui
