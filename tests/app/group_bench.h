// What tests of groups in panels share: a painting with groups, and hands on the inspector.
#pragma once

#include "app/panels/inspector/group_section.h"
#include "app/panels/inspector/inspector_panel.h"
#include "app/widgets/numbers/number_field.h"
#include "tests/app/panel_bench.h"
#include "undo/layers/group_edits.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>

namespace suffuse {

/// Chooses an item by keys, as a hand does that has opened the list.
inline void chooseItem(QComboBox &box, int index)
{
    box.setFocus();
    box.showPopup();
    QAbstractItemView &list = *box.view();
    QVERIFY(QTest::qWaitForWindowExposed(list.window()));
    list.setCurrentIndex(list.model()->index(index, 0));
    QTest::keyClick(&list, Qt::Key_Return);
}

/// Six strokes; 1 and 2 are a group, and so are 3 and 4.
struct GroupBench : Bench {
    GroupBench() : Bench(6)
    {
        first = group({1, 2}, "first");
        second = group({3, 4}, "second");
        editor.undoStack().clear();
        select({});
    }
    GroupId group(std::set<StrokeId> strokes, const QString &name)
    {
        select(std::move(strokes));
        editor.push(groupSelection(editor.document(), name), "group");
        return editor.document().painting()->groups.back().id;
    }
    const Group &of(GroupId id) { return *editor.document().painting()->findGroup(id); }

    GroupId first = 0, second = 0;
};

struct Inspecting : GroupBench {
    Inspecting()
    {
        panel.resize(320, 1400);
        panel.show();
    }
    GroupSection &section() { return *panel.groupSection(); }
    NumberField &opacity() { return *section().opacity()->number(); }
    void choose(BlendMode mode)
    {
        QComboBox &box = *section().mode();
        chooseItem(box, box.findData(int(mode)));
    }
    void clickIsolated()
    {
        QTest::mouseClick(section().isolated(), Qt::LeftButton, {}, {8, section().isolated()->height() / 2});
    }

    void clickRole(GroupRole role)
    {
        QCheckBox &box = *section().roleSwitch(role);
        QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
    }

    InspectorPanel panel{editor};
};

} // namespace suffuse
