// What a screen reader says: everything that can have the keyboard has a name, and what has no words of its own is described.
#include "app/session/settings/settings.h"
#include "app/session/translation.h"
#include "app/widgets/habits/spoken_names.h"
#include "tests/app/window/hands_on_widgets.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QComboBox>
#include <QLabel>
#include <QTabBar>

using namespace suffuse;

namespace {

/// The widget for people who have to mend it.
QString pathOf(const QWidget &widget)
{
    QStringList path;
    for (const QWidget *w = &widget; w && path.size() < 4; w = w->parentWidget())
        path.prepend(QString::fromLatin1(w->metaObject()->className()) + '#' + w->objectName());
    return path.join(" > ");
}

/// The viewport of a scroll area has the keyboard by its area.
bool isPartOfAnother(const QWidget &widget)
{
    const QWidget *parent = widget.parentWidget();
    return parent && (parent->focusProxy() == &widget || parent->inherits("QComboBox") ||
                      parent->inherits("QAbstractSpinBox") || widget.inherits("QScrollBar"));
}

/// Buttons that Qt shows where tabs have no room, and names itself; bars of tabs without a tab.
bool isUnused(const QWidget &widget)
{
    const auto *bar = qobject_cast<const QTabBar *>(&widget);
    return qobject_cast<const QTabBar *>(widget.parentWidget()) || (bar && bar->count() == 0);
}

bool hasLetter(const QString &text)
{
    return std::ranges::any_of(text, [](QChar c) { return c.isLetter(); });
}

bool isLabelled(const QWidget &widget)
{
    const QList<QLabel *> labels = widget.window()->findChildren<QLabel *>();
    return std::ranges::any_of(labels, [&](const QLabel *label) { return label->buddy() == &widget; });
}

/// What is wrong with the words of a widget; empty: nothing is.
QString faultOf(QWidget &widget)
{
    QAccessibleInterface *spoken = QAccessible::queryAccessibleInterface(&widget);
    if (!spoken)
        return "no interface";
    const QString name = spoken->text(QAccessible::Name);
    if (!hasLetter(name))
        return "no name: “" + name + "”";
    // A button that is written on says what it does, a field is explained by its label.
    const auto *button = qobject_cast<QAbstractButton *>(&widget);
    const bool isPlain = (button && hasLetter(button->text())) || isLabelled(widget) || widget.inherits("QTabBar");
    if (!isPlain && spoken->text(QAccessible::Description).isEmpty() && widget.whatsThis().isEmpty())
        return "no description: “" + name + "”";
    return {};
}

QStringList faultsIn(QWidget &root, int &count)
{
    QStringList faults;
    QList<QWidget *> widgets = root.findChildren<QWidget *>();
    widgets.prepend(&root);
    for (QWidget *widget : widgets) {
        if (widget->focusPolicy() == Qt::NoFocus || !(widget->focusPolicy() & Qt::TabFocus) || widget->focusProxy() ||
            isPartOfAnother(*widget) || isUnused(*widget) || widget->window() != root.window())
            continue;
        nameOwnWidgetOfQt(*widget); // as when it is seen
        ++count;
        if (const QString fault = faultOf(*widget); !fault.isEmpty())
            faults << pathOf(*widget) + ": " + fault;
    }
    return faults;
}

} // namespace

class TestWordsSpoken : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QVERIFY(m_folder.isValid());
        keepSettingsIn(m_folder);
        settings::setLanguage("en");
        installTranslators();
    }

    /// With each tool in the hand, since it has fields of its own, and with strokes, fills and groups selected.
    void everythingInTheWindowHasAName()
    {
        WaveSession s;
        QStringList faults;
        int count = 0;
        for (const Command tool : tools) {
            s.use(tool);
            s.editor().document().setSelection({{s.id}, {}});
            s.editor().laterChanges().flush();
            QCoreApplication::processEvents();
            faults << faultsIn(s.window, count);
        }
        faults.removeDuplicates();
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
        QVERIFY2(count > 1000, qPrintable(QString::number(count)));
    }

    void everythingInDialogsHasAName()
    {
        WaveSession s;
        s.editor().document().setSelection({{s.id}, {}});
        QStringList faults;
        int count = 0;
        for (const DialogMaker &maker : allDialogs()) {
            const std::unique_ptr<QDialog> dialog = maker.make(s.window);
            dialog->ensurePolished();
            for (const QString &fault : faultsIn(*dialog, count))
                faults << QString(maker.name) + ": " + fault;
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join('\n')));
        QVERIFY2(count > 150, qPrintable(QString::number(count)));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(TestWordsSpoken)
#include "test_words_spoken.moc"
