#pragma once

#include "length_field.h"

#include <QVariantMap>
#include <QWidget>

class QPushButton;
class QTableWidget;

namespace mesher::gui {

/// Sizes of single faces, edges and vertices: a table of names and lengths, filled from a selection elsewhere.
class LocalSizeTable : public QWidget
{
    Q_OBJECT

public:
    explicit LocalSizeTable(QuantityFieldMaker makeField, QWidget* parent = nullptr);

    /// Name to millimetres; rows without a size are left out.
    [[nodiscard]] QVariantMap sizes() const;
    void setSizes(const QVariantMap& sizes);

Q_SIGNALS:
    void sizesChanged();
    void selectionWanted();

private:
    void addRow(const QString& name, double size);
    void showIfFilled();
    void removeCurrent();

    QuantityFieldMaker makeField_;
    QTableWidget* table_;
    QPushButton* remove_;
};

}  // namespace mesher::gui
