#pragma once

#include <QVariantList>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QSlider;
class QTableWidget;

namespace mesher::gui {

/// Where to cut a mesh, and a table of its worst elements to choose from. It shows no mesh itself.
class InspectionPanel : public QWidget
{
    Q_OBJECT
    Q_PROPERTY(int axis READ axis WRITE setAxis)        ///< -1 no cut, 0 … 2 across x, y, z
    Q_PROPERTY(double share READ share WRITE setShare)  ///< of the mesh's extent that is cut away, 0 to 1
    Q_PROPERTY(bool flipped READ isFlipped)             ///< the other side is cut away
    Q_PROPERTY(QVariantList worst READ worst WRITE setWorst)  ///< a list of texts for each row
    Q_PROPERTY(int chosen READ chosen)                        ///< row of the table, -1 none

public:
    explicit InspectionPanel(QWidget* parent = nullptr);

    [[nodiscard]] int axis() const;
    void setAxis(int axis);
    [[nodiscard]] double share() const;
    void setShare(double share);
    [[nodiscard]] bool isFlipped() const;
    [[nodiscard]] QVariantList worst() const { return worst_; }
    void setWorst(const QVariantList& rows);
    [[nodiscard]] int chosen() const;

Q_SIGNALS:
    void cutChanged();
    void worstChosen();

private:
    void layOut();

    QComboBox* axis_;
    QSlider* share_;
    QCheckBox* flip_;
    QTableWidget* table_;
    QVariantList worst_;
};

}  // namespace mesher::gui
