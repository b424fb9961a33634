// The list of strokes: a vector whose copies share.
#include "model/painting/stroke_values.h"

#include <QtTest>

#include <algorithm>
#include <random>

using namespace suffuse;

class TestStrokeList : public QObject {
    Q_OBJECT

    static StrokePtr strokeWithId(StrokeId id)
    {
        Stroke s;
        s.id = id;
        return std::make_shared<const Stroke>(std::move(s));
    }
    static bool same(const StrokeList &list, const std::vector<StrokePtr> &vector)
    {
        return list.size() == vector.size() && list.empty() == vector.empty() &&
               std::equal(list.begin(), list.end(), vector.begin(), vector.end()) &&
               std::equal(list.rbegin(), list.rend(), vector.rbegin(), vector.rend());
    }

private slots:
    /// Every operation does what a vector does, and copies made along the way keep what they had.
    void isAVector()
    {
        std::mt19937_64 random(7);
        StrokeList list;
        std::vector<StrokePtr> vector;
        std::vector<std::pair<StrokeList, std::vector<StrokePtr>>> kept;
        for (StrokeId id = 1; id < 4000; ++id) {
            const auto place = std::ptrdiff_t(vector.empty() ? 0 : random() % vector.size());
            switch (vector.empty() ? 0 : random() % 12) {
            case 6:
                list.insert(list.begin() + place, strokeWithId(id));
                vector.insert(vector.begin() + place, list[std::size_t(place)]);
                break;
            case 7:
                list.erase(list.begin() + place);
                vector.erase(vector.begin() + place);
                break;
            case 8:
                list.pop_back();
                vector.pop_back();
                break;
            case 9:
                list[std::size_t(place)] = strokeWithId(id);
                vector[std::size_t(place)] = std::as_const(list)[std::size_t(place)];
                break;
            case 10:
                std::rotate(list.begin(), list.begin() + place, list.end());
                std::rotate(vector.begin(), vector.begin() + place, vector.end());
                break;
            case 11:
                if (random() % 40 == 0) {
                    list.resize(std::size_t(place));
                    vector.resize(std::size_t(place));
                }
                break;
            default:
                list.push_back(strokeWithId(id));
                vector.push_back(list.back());
            }
            if (id % 100 == 0)
                kept.emplace_back(list, vector);
            QVERIFY(same(list, vector));
        }
        QVERIFY(vector.size() > 200);
        for (const auto &[l, v] : kept)
            QVERIFY(same(l, v));
        QCOMPARE(std::as_const(list).at(vector.size() - 1), vector.back());
        QVERIFY_EXCEPTION_THROWN(std::as_const(list).at(vector.size()), std::out_of_range);
    }

    void differencesBetweenCopies()
    {
        StrokeList list;
        for (StrokeId id = 1; id <= 1000; ++id)
            list.push_back(strokeWithId(id));
        StrokeList copy = list;
        const auto differences = [&] {
            std::vector<std::size_t> found;
            copy.forEachDifference(list, [&](std::size_t i) { found.push_back(i); });
            return found;
        };
        QVERIFY(differences().empty());
        for (const std::size_t i : {std::size_t(0), std::size_t(63), std::size_t(64), std::size_t(999)})
            copy[i] = strokeWithId(5000 + i);
        QCOMPARE(differences(), (std::vector<std::size_t>{0, 63, 64, 999}));
        const StrokeList other(list.begin(), list.end()); // equal strokes, nothing shared
        copy = other;
        QVERIFY(differences().empty());
    }

    /// What is found out of each stroke is found out again of those that changed alone, wherever others come and go.
    void valuesAreKeptOfWhatStays()
    {
        std::mt19937_64 random(11);
        StrokeList list;
        StrokeId next = 1;
        while (next <= 2000)
            list.push_back(strokeWithId(next++));
        StrokeValues<StrokeId> values;
        int asked = 0;
        const auto idOf = [&asked](const Stroke &stroke) {
            ++asked;
            return stroke.id;
        };
        const auto areThoseOf = [&](const StrokeList &strokes) {
            return std::equal(values.begin(), values.end(), strokes.begin(), strokes.end(),
                              [](StrokeId id, const StrokePtr &stroke) { return id == stroke->id; });
        };
        QVERIFY(!values.follow(list, idOf));
        QCOMPARE(asked, 2000);
        for (int step = 0; step < 500; ++step) {
            const auto place = [&] { return list.begin() + std::ptrdiff_t(random() % list.size()); };
            const StrokeList before = list;
            const std::size_t kind = random() % 4;
            asked = 0;
            int changed = 2;
            if (kind == 0) { // one falls into three, another goes
                const auto at = place();
                *at = strokeWithId((*at)->id);
                list.insert(at + 1, strokeWithId(next++));
                list.insert(at + 2, strokeWithId(next++));
                list.erase(place());
                changed = 3;
            } else if (kind == 1) { // a run goes
                const std::size_t from = random() % (list.size() - 40);
                for (std::size_t i = from; i < from + 40; ++i)
                    list.erase(list.begin() + std::ptrdiff_t(from));
                changed = 0;
            } else if (kind == 2) { // a run comes
                for (int i = 0; i < 40; ++i)
                    list.insert(list.begin() + 700, strokeWithId(next++));
                changed = 40;
            } else {
                std::iter_swap(place(), place());
            }
            const bool same = std::equal(list.begin(), list.end(), before.begin(), before.end(),
                                         [](const StrokePtr &a, const StrokePtr &b) { return a->id == b->id; });
            QCOMPARE(values.follow(list, idOf), same);
            QVERIFY(areThoseOf(list));
            QVERIFY2(asked <= changed, qPrintable(QString::number(asked)));
        }
        list.clear();
        QVERIFY(!values.follow(list, idOf));
        QVERIFY(values.begin() == values.end());
    }
};

QTEST_GUILESS_MAIN(TestStrokeList)
#include "test_stroke_list.moc"
