"""Sizes in space as words, as the command line has them: a property of a document keeps words, Python has numbers."""
import mesher


def of_distances(wishes):
    return [f"{entity}={_words(numbers)}" for entity, numbers in wishes.items()]


def of_boxes(wishes):
    return [f"{_words((*wish[0], *wish[1]))}={_words(wish[2:])}" for wish in wishes]


def of_balls(wishes):
    return [f"{_words((*wish[0], wish[1]))}={_words(wish[2:])}" for wish in wishes]


def distances_in(words):
    return {entity: tuple(numbers) for entity, numbers in
            (_parts(word, "size_distance", "Face6=SIZE,GROWTH[,PLATEAU]", (2, 3)) for word in words)}


def boxes_in(words):
    syntax = "X0,Y0,Z0,X1,Y1,Z1=SIZE[,GROWTH]"
    places = [_places(word, "size_box", syntax, 6) for word in words]
    return [(place[:3], place[3:], *numbers) for place, numbers in places]


def balls_in(words):
    places = [_places(word, "size_ball", "X,Y,Z,RADIUS=SIZE[,GROWTH]", 4) for word in words]
    return [(place[:3], place[3], *numbers) for place, numbers in places]


def _words(numbers):
    return ",".join(repr(float(number)) for number in numbers)


def _parts(word, option, syntax, counts):
    """What is before the sign, and the numbers behind it."""
    before, _, behind = word.partition("=")
    try:
        numbers = [float(number) for number in behind.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) not in counts or not before.strip():
        _refuse(word, option, syntax)
    return before.strip(), numbers


def _places(word, option, syntax, count):
    before, numbers = _parts(word, option, syntax, (1, 2))
    try:
        place = [float(number) for number in before.split(",")]
    except ValueError:
        place = []
    if len(place) != count:
        _refuse(word, option, syntax)
    return place, numbers


def _refuse(word, option, syntax):
    reason, remedy = f"'{word}' cannot be read", f"write {syntax}"
    failure = {"entity": option, "point": None, "reason": reason, "remedy": remedy}
    raise mesher.OptionError(f"{option}: {reason}; {remedy}.", [failure])
