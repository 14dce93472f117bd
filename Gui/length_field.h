#pragma once

#include <QWidget>

#include <functional>

class QAbstractSpinBox;
class QLabel;
class QLineEdit;

namespace mesher::gui {

/// Makes FreeCAD's own field for quantities, with which units, expressions and the user's unit schema come, by what it is for. Whoever
/// shows a panel hands it in, since this folder knows nothing of FreeCAD. What it makes has properties `unit`, `minimum` and `rawValue`
/// and a signal `valueChanged(double)`; it belongs to nobody yet.
using QuantityFieldMaker = std::function<QWidget*(const QString& name)>;

/// A length in such a field, with a word beside it while it is 0.
///
/// A separator of thousands where none can be is taken for the decimal one: "5,5" is 5.5 in English as well, where FreeCAD's field
/// leaves the comma out and makes 55 of it.
class LengthField : public QWidget
{
    Q_OBJECT

public:
    /// The field is called `name`; `none` is what 0 means.
    LengthField(const QuantityFieldMaker& make, const QString& name, const QString& none,
                QWidget* parent = nullptr);

    /// Millimetres.
    [[nodiscard]] double value() const;
    void setValue(double value);
    /// FreeCAD's field in it; none once it was let go.
    [[nodiscard]] QWidget* field() const;
    /// Takes FreeCAD's field away, which must not outlive the object whose property it is bound to: its expression would be looked for
    /// there. The value stays.
    void letFieldGo();

Q_SIGNALS:
    void valueChanged();

private Q_SLOTS:
    void onValueChanged();

private:
    void rememberTyped(const QString& text);
    void settleTyped();

    QAbstractSpinBox* field_;
    QLineEdit* edit_;
    QLabel* none_;
    double lastValue_ = 0.0;
    QString
        decimal_;  ///< what was typed, with the separator put right; empty if there is nothing to put right
};

/// The text with its separator of thousands replaced by the decimal one if it cannot be one of thousands, or else nothing.
[[nodiscard]] QString withDecimalSeparator(const QString& text, const QLocale& locale);

}  // namespace mesher::gui
