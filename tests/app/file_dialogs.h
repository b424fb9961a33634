// Answers to dialogs that wait for the user.
#pragma once

#include <QAbstractItemView>
#include <QApplication>
#include <QFileDialog>
#include <QLineEdit>
#include <QTest>
#include <QTimer>

#include <functional>

namespace suffuse {

/// Does something with the dialog of this type that comes next, and counts it.
template <typename Dialog>
void whenAsked(QObject *context, int &answered, const std::function<void(Dialog &)> &act)
{
    auto *timer = new QTimer(context);
    QObject::connect(timer, &QTimer::timeout, context, [timer, act, &answered] {
        auto *dialog = qobject_cast<Dialog *>(QApplication::activeModalWidget());
        if (!dialog)
            return;
        timer->stop();
        timer->deleteLater();
        ++answered;
        act(*dialog);
    });
    timer->start(20);
}

/// Types a name into the file dialog that comes next, and takes it.
inline void whenAskedForFile(QObject *context, int &answered, const QString &name)
{
    whenAsked<QFileDialog>(context, answered, [name](QFileDialog &dialog) {
        auto *field = dialog.findChild<QLineEdit *>(QStringLiteral("fileNameEdit"));
        field->setText(name);
        // What the list has selected goes first. It loses that when something is typed, but not by setText.
        dialog.findChild<QAbstractItemView *>(QStringLiteral("listView"))->clearSelection();
        field->setText(name);
        QTest::keyClick(field, Qt::Key_Return);
    });
}

} // namespace suffuse
