#include "length_field.h"

#include <QAbstractSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>

#include <stdexcept>

namespace mesher::gui {

namespace {

constexpr int kSpacing = 4;  // pixels

QAbstractSpinBox* checkedField(QWidget* widget)
{
    auto* field = qobject_cast<QAbstractSpinBox*>(widget);
    if (field == nullptr || field->metaObject()->indexOfProperty("rawValue") < 0 ||
        field->findChild<QLineEdit*>() == nullptr)
        throw std::invalid_argument("the field that was made is not one of FreeCAD's for quantities");
    return field;
}

}  // namespace

QString withDecimalSeparator(const QString& text, const QLocale& locale)
{
    const QString group(locale.groupSeparator());
    if (text.count(group) != 1) return {};
    static const QRegularExpression digits(QStringLiteral("^[0-9]*"));
    const auto place = text.indexOf(group);
    const auto behind = digits.match(text.mid(place + 1)).capturedLength();
    if (behind == 0 || behind == 3) return {};
    const QString decimal(locale.decimalPoint());
    return text.contains(decimal) ? QString() : text.left(place) + decimal + text.mid(place + 1);
}

LengthField::LengthField(const QuantityFieldMaker& make, const QString& name, const QString& none,
                         QWidget* parent)
    : QWidget(parent),
      field_(checkedField(make(name))),
      edit_(field_->findChild<QLineEdit*>()),
      none_(new QLabel(none, this))
{
    field_->setObjectName(name);
    field_->setProperty("unit", QStringLiteral("mm"));
    field_->setProperty("minimum", 0.0);
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(kSpacing);
    all->addWidget(field_, 1);
    all->addWidget(none_);
    setFocusProxy(field_);
    connect(edit_, &QLineEdit::textEdited, this, &LengthField::rememberTyped);
    connect(field_, &QAbstractSpinBox::editingFinished, this, &LengthField::settleTyped);
    connect(field_, SIGNAL(valueChanged(double)), this, SLOT(onValueChanged()));
}

QWidget* LengthField::field() const { return field_; }

double LengthField::value() const
{
    return field_ != nullptr ? field_->property("rawValue").toDouble() : lastValue_;
}

void LengthField::setValue(double value)
{
    if (field_ == nullptr) return;
    field_->setProperty("rawValue", value);
    onValueChanged();
}

void LengthField::letFieldGo()
{
    if (field_ == nullptr) return;
    lastValue_ = value();
    QAbstractSpinBox* field = field_;
    field_ = nullptr;
    disconnect(field, nullptr, this, nullptr);
    // Whoever asks for this may be called by the field; without a window it hears of nothing more.
    field->hide();
    field->setParent(nullptr);
    field->deleteLater();
}

void LengthField::rememberTyped(const QString& text) { decimal_ = withDecimalSeparator(text, QLocale()); }

/// Not while it is typed: "1,0" may become "1,000".
void LengthField::settleTyped()
{
    if (decimal_.isEmpty()) return;
    QString text;
    text.swap(decimal_);
    edit_->setText(text);
    setValue(value());  // which shows it with its unit
}

void LengthField::onValueChanged()
{
    none_->setVisible(value() == 0.0);
    Q_EMIT valueChanged();
}

}  // namespace mesher::gui
