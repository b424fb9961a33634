// A stroke or a group as screen readers see it.
#pragma once

#include "app/canvas/reading/stroke_tree.h"

#include <QAccessible>
#include <QPointer>

namespace suffuse {

class CanvasReading;

/// Answers for one stroke or one group of a canvas. All is read off the painting when it is asked.
class ReadItem : public QAccessibleInterface, public QAccessibleActionInterface {
public:
    ReadItem(CanvasReading &reading, const TreeItem &item);
    ~ReadItem() override;

    const TreeItem &item() const { return m_item; }

    bool isValid() const override;
    QObject *object() const override { return nullptr; }
    QWindow *window() const override;
    QAccessibleInterface *childAt(int x, int y) const override;
    QAccessibleInterface *parent() const override;
    QAccessibleInterface *child(int index) const override;
    int childCount() const override;
    int indexOfChild(const QAccessibleInterface *child) const override;
    QString text(QAccessible::Text kind) const override;
    void setText(QAccessible::Text kind, const QString &text) override;
    QRect rect() const override;
    QAccessible::Role role() const override;
    QAccessible::State state() const override;
    void *interface_cast(QAccessible::InterfaceType type) override;

    QStringList actionNames() const override;
    QString localizedActionName(const QString &name) const override;
    QString localizedActionDescription(const QString &name) const override;
    void doAction(const QString &name) override;
    QStringList keyBindingsForAction(const QString &) const override { return {}; }

private:
    const std::vector<TreeItem> &children() const;

    QPointer<CanvasReading> m_reading;
    TreeItem m_item;
};

} // namespace suffuse
