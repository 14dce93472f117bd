#pragma once

#include <QStringList>
#include <QVariantMap>
#include <QWidget>

class QTableWidget;

namespace mesher::gui {

/// Sizes of single faces, edges and vertices: a table of names and lengths, filled from a selection elsewhere.
class LocalSizeTable : public QWidget
{
    Q_OBJECT

public:
    explicit LocalSizeTable(QWidget* parent = nullptr);

    /// Name to millimetres; rows without a size are left out.
    [[nodiscard]] QVariantMap sizes() const;
    void setSizes(const QVariantMap& sizes);
    /// Adds rows for names that have none.
    void addNames(const QStringList& names, double size);

Q_SIGNALS:
    void sizesChanged();
    void selectionWanted();

private:
    void addRow(const QString& name, double size);
    void removeCurrent();

    QTableWidget* table_;
};

}  // namespace mesher::gui
