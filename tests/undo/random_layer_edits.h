// Random edits of layers for the tests of undo.
#pragma once

#include "tests/undo/random_edits.h"
#include "undo/layers/emptied_groups.h"
#include "undo/layers/group_edits.h"
#include "undo/layers/group_roles.h"
#include "undo/layers/layer_edits.h"
#include "undo/layers/merge_layers.h"

namespace suffuse::test {

/// One of all the edits of groups and layers, or one that paints, deletes or orders what is in them; may be empty.
class LayerEdits {
public:
    LayerEdits(Document &document, unsigned seed) : m_document(document), m_others(document, seed) {}

    Edit next()
    {
        switch (below(24)) {
        case 0:
        case 1:
            selectSome();
            return groupSelection(m_document, QString::number(below(100)));
        case 2:
            selectSome();
            return below(3) ? ungroup(m_document, anyGroup()) : ungroupSelection(m_document);
        case 3:
            return setGroupOpacity(m_document, someGroups(), float(below(101)) / 100);
        case 4:
            return setGroupBlend(m_document, someGroups(), BlendMode(below(blendModes)));
        case 5:
            return setGroupIsolated(m_document, someGroups(), below(2));
        case 6:
        case 7:
            return setGroupRole(m_document, someGroups(), groupRoles[std::size_t(below(int(groupRoles.size())))],
                                below(3));
        case 8:
            return setGroupTag(m_document, someGroups(), GroupTag(below(9)));
        case 9: {
            GroupId copy = 0;
            return isLarge() ? Edit() : duplicateGroup(m_document, anyGroup(), QStringLiteral("copy"), copy);
        }
        case 10:
        case 11:
            return moveGroup(m_document, anyGroup(), below(2));
        case 12:
            return toggleSolo(m_document, anyGroup());
        case 13:
            return setGroupVisible(m_document, anyGroup(), below(4));
        case 14:
            return setGroupLocked(m_document, anyGroup(), below(4) == 0);
        case 15:
            return below(2) ? showAll(m_document) : unlockAll(m_document);
        case 16:
            return renameGroup(m_document, anyGroup(), QString::number(below(1000)));
        case 17:
            return mergeDown(m_document, anyGroup()).edit;
        case 18:
        case 19:
            return painted();
        case 20:
            return below(2) ? deleteEmptyGroup(m_document, anyGroup()) : deleteGroup();
        default:
            return isLarge() ? deleteGroup() : m_others.next();
        }
    }

    int below(int n) { return m_others.below(n); }

private:
    const Painting &painting() const { return *m_document.painting(); }
    bool isLarge() const { return painting().strokes.size() > 60; }

    GroupId anyGroup()
    {
        const auto &groups = painting().groups;
        return groups.empty() ? 0 : groups[std::size_t(below(int(groups.size())))].id;
    }
    std::vector<GroupId> someGroups()
    {
        std::vector<GroupId> some;
        for (int i = below(3); i >= 0; --i)
            some.push_back(anyGroup());
        return some;
    }
    void selectSome()
    {
        Selection some;
        const auto &strokes = painting().strokes;
        const int from = strokes.empty() ? 0 : below(int(strokes.size()));
        for (int i = from; i < std::min(from + 1 + below(5), int(strokes.size())); ++i)
            some.strokes.insert(strokes[std::size_t(i)]->id);
        m_document.setSelection(some);
    }
    /// A stroke that comes into a layer, at one of its ends.
    Edit painted()
    {
        const Edit edit =
            addStrokes(m_document, {makeStroke(m_document.takeStrokeId(), below(500), below(300))}, below(2));
        PaintedLayer layer;
        layer.group = layerAround(painting(), anyGroup());
        return endingSolo(m_document,
                          addedToLayer(m_document, edit, layer, below(4) ? LayerEnd::Top : LayerEnd::Bottom));
    }
    Edit deleteGroup()
    {
        const GroupId group = anyGroup();
        Selection all;
        for (const StrokePtr &stroke : painting().strokes)
            if (isWithin(painting(), stroke->group, group))
                all.strokes.insert(stroke->id);
        m_document.setSelection(all);
        return deleteSelection(m_document);
    }
    static bool isWithin(const Painting &painting, GroupId inner, GroupId outer)
    {
        for (; inner != 0; inner = painting.findGroup(inner)->parent)
            if (inner == outer)
                return true;
        return false;
    }

    Document &m_document;
    RandomEdits m_others;
};

} // namespace suffuse::test
