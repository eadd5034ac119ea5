"""What tests/scripts/serve_test.sh asks a running `knuckle serve`. serve_test.py KNUCKLE"""
import http.client
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time

PROGRAM, SCENE, SIZE = sys.argv[1], "assets/scenes/hello.json", (160, 90)
failures = []


def check(holds, what):
    if not holds:
        failures.append(what)
        print("serve:", what, file=sys.stderr)


class Served:
    """The program while it serves on a free port."""

    def __init__(self, *options, scene=SCENE):
        self.process = subprocess.Popen(
            [PROGRAM, "--device", "software", "serve", scene, "--port", "0", "--size", "%dx%d" % SIZE, "--hash", *options],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        line = self.process.stdout.readline()
        found = re.search(r"http://127\.0\.0\.1:(\d+)/", line)
        if not found:
            sys.exit("serve: it does not start: %s%s" % (line, self.process.stderr.read()))
        self.port = int(found.group(1))

    def ask(self, method, path, body=None, **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        connection.request(method, path, body, {name.replace("_", "-"): value for name, value in headers.items()})
        answer = connection.getresponse()
        return answer.status, answer.read() if "stream" not in path and "events" not in path else answer

    def wish(self, **wish):
        status, text = self.ask("POST", "/input", json.dumps(wish))
        return json.loads(text) if status == 200 else status

    def figures(self):
        status, answer = self.ask("GET", "/events")
        return json.loads(answer.readline().split(b"data: ", 1)[1])

    def until(self, holds, what):
        for _ in range(100):
            figures = self.figures()
            if holds(figures):
                return figures
            time.sleep(0.05)
        check(False, what + ": " + json.dumps(figures))
        return figures

    def end(self):
        self.process.send_signal(signal.SIGINT)
        out, err = self.process.communicate(timeout=20)
        check(self.process.returncode == 130, "Ctrl-C ends it with %d: %s" % (self.process.returncode, err))
        return re.search("state hash ([0-9a-f]{16})", out).group(1)


def frames_of(answer, count):
    """Pictures of a stream, and their sizes by their JPEG headers."""
    sizes = []
    for _ in range(count):
        length = 0
        while True:
            line = answer.readline()
            if line.lower().startswith(b"content-length:"):
                length = int(line.split(b":")[1])
            if line in (b"\r\n", b"") and length:
                break
        jpeg = answer.read(length)
        check(jpeg[:2] == b"\xff\xd8" and jpeg[-2:] == b"\xff\xd9", "a frame is no JPEG")
        at = jpeg.index(b"\xff\xc0")
        sizes.append((int.from_bytes(jpeg[at + 7:at + 9], "big"), int.from_bytes(jpeg[at + 5:at + 7], "big")))
    return sizes


def look(served):
    status, page = served.ask("GET", "/")
    check(status == 200 and b"<title>hello</title>" in page, "no page")
    check(not re.search(rb"https?://", page), "the page names another site")
    status, answer = served.ask("GET", "/stream")
    check(frames_of(answer, 3) == [SIZE] * 3, "frames have another size")
    answer.close()


def steer(served):
    served.wish(do="pause")
    before = served.until(lambda f: f["paused"], "it does not pause")["step"]
    time.sleep(0.3)
    check(served.figures()["step"] == before, "a pause goes on")
    served.wish(do="step", count=3)
    served.until(lambda f: f["step"] == before + 3, "three steps are others")
    served.wish(do="reset")
    served.until(lambda f: f["step"] == 0, "it does not go back")
    for wish in ({"do": "orbit", "by": [0.1, 0.1]}, {"do": "zoom", "factor": 0.9}, {"do": "home"}):
        check(served.wish(**wish) == {}, "no %s" % wish["do"])


def refuse(served):
    own, other = "http://127.0.0.1:%d" % served.port, "http://example.org"
    check(served.ask("POST", "/input", '{"do": "home"}', Origin=own)[0] == 200, "the own site is refused")
    check(served.ask("POST", "/input", '{"do": "run"}', Origin=other)[0] == 403, "another site may steer")
    for path, status in (("/stream", 403), ("/events", 403), ("/", 200)):
        check(served.ask("GET", path, Sec_Fetch_Site="cross-site")[0] == status, "another site and " + path)
    check(served.ask("GET", "/", Host="example.org")[0] == 403, "another host's name is answered")
    for body in ("", "[]", "{", '{"do": "hom"}', '{"do": "zoom", "factor": 0}', '{"do": "pan", "by": [1]}',
                 '{"do": "orbit", "by": [1e999, 0]}', '{"do": "step", "count": "x"}', "[" * 60000):
        check(served.ask("POST", "/input", body)[0] == 400, "taken: " + body[:40])
    check(served.ask("POST", "/input", "x" * 70000)[0] == 413, "a body that is too large")
    check(served.ask("GET", "/nothing")[0] == 404, "a page that is none")
    for options, words in ((["--port", str(served.port)], "is in use"), (["--host", "0.0.0.0"], "--token")):
        run = subprocess.run([PROGRAM, "serve", SCENE, *options], capture_output=True, text=True)
        check(run.returncode == 2 and run.stderr.count("\n") == 1 and words in run.stderr, str(options) + run.stderr)


def crowd(served):
    served.wish(do="run")
    answers = [served.ask("GET", "/stream") for _ in range(30)]
    check([status for status, _ in answers].count(200) == 16, "not 16 of 30 are served")
    check([status for status, _ in answers].count(503) == 14, "not 14 of 30 are refused")
    # None of them reads, and one has not even asked.
    idle = socket.create_connection(("127.0.0.1", served.port))
    before = served.figures()["step"]
    served.until(lambda f: f["step"] > before + 20, "who does not read holds up the simulation")
    for _, answer in answers:
        answer.close()
    idle.close()
    served.until(lambda f: f["viewers"] == 0, "who has gone still counts")


def speed(served):
    """Steps a second."""
    first, began = served.figures()["step"], time.time()
    time.sleep(2)
    return (served.figures()["step"] - first) / (time.time() - began)


def hundred(served):
    """A hundred connections that ask for nothing, or for pictures and read none: steps go on at their speed."""
    served.wish(do="run")
    alone = speed(served)
    idle = []
    for k in range(100):
        connection = socket.create_connection(("127.0.0.1", served.port))
        if k % 2:
            connection.sendall(b"GET /stream HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        idle.append(connection)
        # Those that listen already are served on; the others' turn comes when some of these are given up.
        if k == 0:
            listening = served.ask("GET", "/events")[1]
    steps = []
    for line in iter(listening.readline, b""):
        if line.startswith(b"data: "):
            steps.append((time.time(), json.loads(line[6:])["step"]))
        if steps and steps[-1][0] - steps[0][0] > 3:
            break
    crowded = (steps[-1][1] - steps[0][1]) / (steps[-1][0] - steps[0][0])
    check(crowded > 0.8 * alone, "%.1f steps a second among a hundred connections, %.1f alone" % (crowded, alone))
    listening.close()
    for connection in idle:
        connection.close()
    served.until(lambda f: f["viewers"] == 0, "who has gone still counts")


def find(served, wish, kind="isBody", bodies=True):
    """Asks from the middle outwards until something is of a kind."""
    for x, y in [(0.5, 0.5)] + [(x / 20, y / 20) for y in range(4, 18, 2) for x in range(2, 19)]:
        found = served.wish(do=wish, at=[x, y], **({"speed": 3} if wish == "throw" else {}))
        if found.get(kind) and (bodies or not found["isBody"]):
            return found["name"], (x, y)
    check(False, "nothing to " + wish)
    return "", (0.5, 0.5)


def interact(log):
    served = Served("--log", log)
    served.wish(do="pause")
    served.wish(do="reset")
    name, (x, y) = find(served, "pick")
    check(name != "", "nothing has a name")
    find(served, "throw")
    served.wish(do="step", count=10)
    served.until(lambda f: f["step"] == 10, "no ten steps")
    find(served, "grab")
    served.wish(do="drag", at=[x, max(0.0, y - 0.3)])
    served.wish(do="step", count=20)
    served.until(lambda f: f["step"] == 30, "no twenty steps")
    served.wish(do="drop")
    served.wish(do="push", name=name, impulse=[1, 2, 3])
    served.wish(do="push", name="nobody", impulse=[1, 2, 3])
    served.wish(do="step", count=10)
    served.until(lambda f: f["step"] == 40, "no last steps")
    return served.end()


def replayed(log, scene=SCENE, *options):
    return subprocess.run([PROGRAM, "--device", "software", "serve", scene, "--replay", log, "--hash", *options],
                          capture_output=True, text=True)


def same(log, hash, scene=SCENE, *options):
    run = replayed(log, scene, *options)
    check(run.returncode == 0 and "state hash " + hash in run.stdout,
          "%s replayed: %s%s" % (scene, run.stdout, run.stderr))


def field(figures, name):
    return next(field["value"] for field in figures["fields"] if field["name"] == name)


def settings(log):
    """Gravity changes the state at once, a reset brings it back; what cannot change wants a restart."""
    served = Served("--log", log)
    served.wish(do="pause")
    served.wish(do="reset")
    for body in ({"field": "gravity", "value": [0, -3, 0, 1]}, {"field": "gravity", "value": 3},
                 {"field": "gravity", "value": [0, -300, 0]}, {"field": "solver.substeps", "value": 8},
                 {"field": "gravty", "value": [0, 0, 0]}, {"field": "gravity"}, {"value": 1}):
        status, text = served.ask("POST", "/input", json.dumps({"do": "set", **body}))
        check(status == 400 and text.count(b"\n") == 1, "taken: %s: %s" % (body, text))
    check(served.wish(do="set", field="gravity", value=[0, 9, 2]) == {}, "gravity does not change")
    served.wish(do="step", count=30)
    figures = served.until(lambda f: f["step"] == 30 and f["maxSpeed"] > 4, "nothing falls upwards")
    check(field(figures, "gravity") == [0, 9, 2], "another gravity")
    served.wish(do="set", field="linearDamping", value=5)
    served.wish(do="step", count=10)
    served.until(lambda f: f["step"] == 40, "no ten steps")
    first = served.end()
    same(log, first)
    served = Served("--log", log)
    served.wish(do="pause")
    served.wish(do="set", field="gravity", value=[0, 9, 2])
    served.wish(do="reset")
    served.until(lambda f: field(f, "gravity")[1] < -9, "a reset keeps gravity")
    for sets in ("solver.substeps=8", ["solver.substep=8"], ["x"]):
        status, text = served.ask("POST", "/input", json.dumps({"do": "restart", "set": sets}))
        check(status == 400 and text.count(b"\n") == 1, "restarted: %s: %s" % (sets, text))
    check(served.wish(do="restart", set=["solver.substeps=8"]) == {}, "no restart")
    served.wish(do="set", field="gravity", value=[1, -5, 0])
    served.wish(do="step", count=20)
    figures = served.until(lambda f: f["step"] == 20, "no steps after a restart")
    check(figures["paused"] and figures["restarts"] == ["solver.substeps=8"], "a restart is not told")
    second = served.end()
    check(first != second, "a restart changes nothing")
    same(log, second)


def pulled(log, scene):
    """What has no bodies can be pulled, too."""
    served = Served("--log", log, scene=scene)
    served.wish(do="pause")
    served.wish(do="reset")
    name, (x, y) = find(served, "grab", "canBePulled", bodies=False)
    for step in range(20):
        served.wish(do="drag", at=[x, max(0.0, y - 0.4)])
        served.wish(do="step", count=1)
        served.until(lambda f: f["step"] == step + 1, "no step")
    hash = served.end()
    stirs = [line for line in map(json.loads, open(log)) if line.get("stir") == name]
    check(len(stirs) == 20, "%s: %d pulls of %s" % (scene, len(stirs), name))
    check(stirs and stirs[-1]["at"][1] > stirs[0]["at"][1] + 0.05, "%s: it does not rise: %s" % (scene, stirs[-1:]))
    same(log, hash, scene)


def ball(log):
    """It is not there until it is thrown, then flies as thrown, also a second time and after a reset."""
    served = Served("--log", log, "--ball", "0.2")
    served.wish(do="pause")
    served.wish(do="reset")
    still = served.until(lambda f: f["step"] == 0, "no start")
    check(still["hasBall"], "the ball is not told")
    for speed in (20, 10):
        check(served.wish(do="ball", at=[0.5, 0.5], speed=speed) == {}, "no ball is thrown")
        # Gravity adds less than a metre a second in three steps.
        at = served.figures()["step"]
        served.wish(do="step", count=3)
        served.until(lambda f: f["step"] == at + 3 and abs(f["maxSpeed"] - speed) < 1, "it does not fly")
    served.wish(do="reset")
    served.wish(do="step", count=20)
    served.until(lambda f: f["step"] == 20 and f["maxSpeed"] < 8, "a reset leaves the ball")
    served.wish(do="ball", at=[0.5, 0.6], speed=15)
    served.wish(do="step", count=40)
    served.until(lambda f: f["step"] == 60, "no forty steps")
    same(log, served.end(), SCENE, "--ball", "0.2")
    throws = [line for line in map(json.loads, open(log)) if "throw" in line]
    check(len(throws) == 3, "%d throws are logged" % len(throws))
    run = replayed(log)
    check(run.returncode == 2 and "another world" in run.stderr, "replayed without a ball: " + run.stderr)
    served = Served()
    status, text = served.ask("POST", "/input", '{"do": "ball", "at": [0.5, 0.5], "speed": 8}')
    check(status == 400 and b"--ball" in text and text.count(b"\n") == 1, "a ball that is none: %s" % text)
    served.end()


def killed(log):
    """A log counts up to its last line, whatever ends the program."""
    states = []
    for signalled in (signal.SIGINT, signal.SIGKILL):
        served = Served("--log", log)
        served.wish(do="pause")
        served.wish(do="reset")
        name, _ = find(served, "pick")
        served.wish(do="step", count=12)
        served.until(lambda f: f["step"] == 12, "no twelve steps")
        served.wish(do="push", name=name, impulse=[1, 2, 3])
        served.figures()
        if signalled == signal.SIGINT:
            states.append(served.end())
            continue
        served.process.kill()
        served.process.communicate()
        with open(log, "a") as file:
            file.write('{"step":13,"pu')
    run = replayed(log)
    check(run.returncode == 0 and "state hash " + states[0] in run.stdout and "not recorded" in run.stderr,
          "a log without its end: %s%s" % (run.stdout, run.stderr))


def faulty(log):
    """Logs that are none: one line that names the faulty one."""
    head = open(log).readline()
    lines = ('{"step":5,"push":"x"}', '{"step":5,"set":"gravity","value":[0]}', '{"step":5,"set":"wind","value":[0,0,0]}',
             '{"step":5,"stir":"x","impulse":[0,0,0],"at":[0,0,0],"radius":1}', '{"step":"x"}', 'x',
             '{"step":5,"reset":true}\n{"step":4,"end":"00"}\n{"step":5,"reset":true}')
    for text in ("", "x\n", "{}\n", *(head + line + "\n" for line in lines)):
        with open(log, "w") as file:
            file.write(text)
        run = replayed(log)
        check(run.returncode == 2 and run.stderr.count("\n") == 1, "a faulty log: %r %s" % (text, run.stderr))


def replay(log, hash):
    lines = [json.loads(line) for line in open(log)]
    check(sum("push" in line for line in lines) == 22, "%d pushes are logged" % sum("push" in line for line in lines))
    check(all("mouse" not in line for line in lines), "the log has a mouse")
    run = subprocess.run([PROGRAM, "--device", "software", "serve", SCENE, "--quality", "good", "--replay", log, "--hash"],
                         capture_output=True, text=True)
    check(run.returncode == 0 and "state hash " + hash in run.stdout, "replayed: %s%s" % (run.stdout, run.stderr))
    plain = subprocess.run([PROGRAM, "serve", SCENE, "--set", "solver.substeps=3", "--replay", log],
                           capture_output=True, text=True)
    check(plain.returncode == 2 and "another world" in plain.stderr, "another world: " + plain.stderr)


def token():
    served = Served("--token", "secret")
    for path, status in (("/", 401), ("/?token=secre", 401), ("/?token=secrets", 401), ("/?token=secret", 200)):
        check(served.ask("GET", path)[0] == status, "%s is not answered by %d" % (path, status))
    check(served.ask("GET", "/", Authorization="Bearer secret")[0] == 200, "the token in a header")
    check(served.ask("POST", "/input", '{"do": "home"}')[0] == 401, "steered without a token")
    served.end()


served = Served()
look(served)
steer(served)
refuse(served)
crowd(served)
hundred(served)
served.end()
with tempfile.TemporaryDirectory() as folder:
    changes = os.path.join(folder, "changes")
    replay(changes, interact(changes))
    ball(os.path.join(folder, "ball"))
    killed(os.path.join(folder, "killed"))
    settings(os.path.join(folder, "settings"))
    faulty(os.path.join(folder, "settings"))
    for scene in ("hourglass", "curtain", "jelly", "layers"):
        pulled(os.path.join(folder, scene), "assets/scenes/%s.json" % scene)
token()
sys.exit(1 if failures else 0)
