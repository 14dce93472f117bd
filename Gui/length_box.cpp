#include "length_box.h"

#include <QRegularExpression>

#include <array>
#include <cmath>
#include <optional>

namespace mesher::gui {

namespace {

constexpr double kLargestLength = 1e7;  // millimetres
constexpr int kDecimals = 6;

struct Unit
{
    const char* name;
    double millimetres;
};

constexpr std::array<Unit, 10> kUnits = {{{"mm", 1.0},
                                          {"cm", 10.0},
                                          {"dm", 100.0},
                                          {"m", 1000.0},
                                          {"um", 1e-3},
                                          {"\u00b5m", 1e-3},
                                          {"in", 25.4},
                                          {"\"", 25.4},
                                          {"ft", 304.8},
                                          {"thou", 0.0254}}};

/// A number and the unit behind it.
std::optional<std::pair<QString, QString>> split(const QString& text)
{
    static const QRegularExpression form(QStringLiteral("^\\s*([0-9.,eE+-]*)\\s*(\\S*)\\s*$"));
    const QRegularExpressionMatch match = form.match(text);
    if (!match.hasMatch()) return std::nullopt;
    return std::pair(match.captured(1), match.captured(2));
}

std::optional<double> lengthOf(const QString& text, const QLocale& locale)
{
    const auto parts = split(text);
    if (!parts) return std::nullopt;
    bool isNumber = false;
    double number = locale.toDouble(parts->first, &isNumber);
    if (!isNumber) number = QLocale::c().toDouble(parts->first, &isNumber);
    if (!isNumber || !std::isfinite(number) || number < 0.0) return std::nullopt;
    if (parts->second.isEmpty()) return number;
    for (const Unit& unit : kUnits) {
        if (parts->second == QString::fromUtf8(unit.name)) return number * unit.millimetres;
    }
    return std::nullopt;
}

bool mayBecomeUnit(const QString& text)
{
    for (const Unit& unit : kUnits) {
        if (QString::fromUtf8(unit.name).startsWith(text)) return true;
    }
    return false;
}

}  // namespace

LengthBox::LengthBox(const QString& none, QWidget* parent) : QDoubleSpinBox(parent)
{
    setDecimals(kDecimals);
    setRange(0.0, kLargestLength);
    setSpecialValueText(none);
    setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    setKeyboardTracking(false);
}

QString LengthBox::textFromValue(double value) const
{
    return locale().toString(value, 'g', kDecimals) + QStringLiteral(" mm");
}

double LengthBox::valueFromText(const QString& text) const
{
    return text == specialValueText() ? 0.0 : lengthOf(text, locale()).value_or(value());
}

QValidator::State LengthBox::validate(QString& text, int&) const
{
    if (text == specialValueText()) return QValidator::Acceptable;
    const std::optional<double> length = lengthOf(text, locale());
    if (length) return *length <= kLargestLength ? QValidator::Acceptable : QValidator::Invalid;
    if (specialValueText().startsWith(text)) return QValidator::Intermediate;
    const auto parts = split(text);
    return parts && mayBecomeUnit(parts->second) ? QValidator::Intermediate : QValidator::Invalid;
}

}  // namespace mesher::gui
