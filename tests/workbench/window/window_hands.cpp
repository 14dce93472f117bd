// Finds and uses widgets of the window from C++. PySide does not hear of the end of what C++ deletes: an object that lies where another
// one lay before is then taken for that one, which is found no more, or ends the program. So a test asks PySide for none of them.
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QKeyEvent>
#include <QLabel>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QTableWidget>

#include <pybind11/pybind11.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace py = pybind11;

namespace {

/// The visible widgets that `isMeant` holds for.
template <class Widget, class Predicate>
std::vector<Widget*> visible(Predicate isMeant)
{
    std::vector<Widget*> found;
    for (QWidget* widget : QApplication::allWidgets()) {
        auto* candidate = qobject_cast<Widget*>(widget);
        if (candidate != nullptr && candidate->isVisible() && isMeant(*candidate)) found.push_back(candidate);
    }
    return found;
}

template <class Widget>
std::vector<Widget*> named(const std::string& name)
{
    return visible<Widget>([&](const Widget& w) { return w.objectName().toStdString() == name; });
}

template <class Widget = QWidget>
Widget& the(const std::string& name)
{
    const std::vector<Widget*> found = named<Widget>(name);
    if (found.size() != 1) throw std::runtime_error(std::to_string(found.size()) + " visible " + name);
    return *found.front();
}

std::vector<QPushButton*> panelButtons(const std::string& word)
{
    return visible<QPushButton>([&](const QPushButton& button) {
        return qobject_cast<QDialogButtonBox*>(button.parent()) != nullptr &&
               button.text().remove(QLatin1Char('&')).toStdString() == word;
    });
}

py::object valueOf(const QVariant& value)
{
    switch (value.userType()) {
        case QMetaType::Bool: return py::bool_(value.toBool());
        case QMetaType::Int: return py::int_(value.toInt());
        case QMetaType::Double: return py::float_(value.toDouble());
        default: return py::str(value.toString().toStdString());
    }
}

QVariant variantOf(const py::object& value)
{
    if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
    if (py::isinstance<py::int_>(value)) return value.cast<int>();
    if (py::isinstance<py::float_>(value)) return value.cast<double>();
    return QString::fromStdString(value.cast<std::string>());
}

void set(const std::string& name, const std::string& property, const py::object& value)
{
    // FreeCAD's field for expressions is a line of text in some versions, and a text of several lines in others.
    if (auto* area = qobject_cast<QPlainTextEdit*>(&the<>(name)); area != nullptr && property == "text") {
        area->setPlainText(QString::fromStdString(value.cast<std::string>()));
        return;
    }
    if (!the<>(name).setProperty(property.c_str(), variantOf(value)))
        throw std::runtime_error(name + " has no property " + property);
}

void click(const std::string& name) { the<QAbstractButton>(name).click(); }

void press(const std::string& word)
{
    const std::vector<QPushButton*> found = panelButtons(word);
    if (found.size() != 1)
        throw std::runtime_error(std::to_string(found.size()) + " visible buttons " + word);
    found.front()->click();
}

Qt::Key keyOf(char letter)
{
    switch (letter) {
        case '=': return Qt::Key_Equal;
        case '\t': return Qt::Key_Tab;
        default: return Qt::Key_unknown;
    }
}

/// Over what is in the field.
void typeKeys(const std::string& name, const std::string& text)
{
    auto& box = the<QAbstractSpinBox>(name);
    box.setFocus();
    box.selectAll();
    for (const char letter : text) {
        for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
            QKeyEvent event(type, keyOf(letter), Qt::NoModifier, QString(QLatin1Char(letter)));
            QApplication::sendEvent(&box, &event);
        }
    }
}

std::string cell(const std::string& name, int row, int column)
{
    return the<QTableWidget>(name).item(row, column)->text().toStdString();
}

void followLink(const std::string& name, const std::string& link)
{
    Q_EMIT the<QLabel>(name).linkActivated(QString::fromStdString(link));
}

/// As by its button, which has another name in each version of FreeCAD.
void acceptDialog(const std::string& className)
{
    const std::vector<QDialog*> open = visible<QDialog>(
        [&](const QDialog& dialog) { return className == dialog.metaObject()->className(); });
    if (open.size() != 1) throw std::runtime_error(std::to_string(open.size()) + " visible " + className);
    open.front()->accept();
}

/// The entry of the menu.
QAction& actionOf(const std::string& name)
{
    for (QWidget* window : QApplication::topLevelWidgets()) {
        if (auto* action = window->findChild<QAction*>(QString::fromStdString(name))) return *action;
    }
    throw std::runtime_error("no action " + name);
}

std::vector<QMessageBox*> messages()
{
    return visible<QMessageBox>([](const QMessageBox&) { return true; });
}

/// The text of the message that is open, which is closed; empty where there is none.
std::string closeMessage()
{
    const std::vector<QMessageBox*> open = messages();
    if (open.empty()) return "";
    const std::string text = open.front()->text().toStdString();
    open.front()->accept();
    return text;
}

void hideDock(const std::string& name)
{
    for (QDockWidget* dock : named<QDockWidget>(name)) dock->hide();
}

/// Of the whole screen, so that what OpenGL draws is on it.
void takePicture(const std::string& path)
{
    if (!QApplication::primaryScreen()->grabWindow(0).save(QString::fromStdString(path)))
        throw std::runtime_error("no picture " + path);
}

}  // namespace

PYBIND11_MODULE(window_hands, module)
{
    module.def("count", [](const std::string& name) { return named<QWidget>(name).size(); });
    module.def("get", [](const std::string& name, const std::string& property) {
        return valueOf(the<>(name).property(property.c_str()));
    });
    module.def("set", &set);
    module.def("click", &click);
    module.def("type_keys", &typeKeys);
    module.def("cell", &cell);
    module.def("rows", [](const std::string& name) { return the<QTableWidget>(name).rowCount(); });
    module.def("select_row",
               [](const std::string& name, int row) { the<QTableWidget>(name).selectRow(row); });
    module.def("accept_dialog", &acceptDialog);
    module.def("follow_link", &followLink);
    module.def("count_buttons", [](const std::string& word) { return panelButtons(word).size(); });
    module.def("press", &press);
    module.def("trigger", [](const std::string& name) { actionOf(name).trigger(); });
    module.def("is_enabled", [](const std::string& name) { return actionOf(name).isEnabled(); });
    module.def("count_messages", [] { return messages().size(); });
    module.def("close_message", &closeMessage);
    module.def("hide_dock", &hideDock);
    module.def("take_picture", &takePicture);
}
