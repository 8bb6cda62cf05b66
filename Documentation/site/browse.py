"""Opens the site in Chromium without a screen, on a wide and on a narrow screen, as a reader would:
the first page, a search, a scene.

usage: browse.py HTML SCREENSHOTS      folders: the built site, and where pictures go
Fails if a search finds nothing, or if a scene is not drawn or does not change when it is cut."""
import functools
import http.server
import os
import sys
import threading

from selenium import webdriver
from selenium.webdriver.common.by import By
from selenium.webdriver.support.ui import WebDriverWait

SCREENS = ((1280, 900), (400, 800))  # pixels
WORD = "fragment"
SECONDS = 60


class QuietHandler(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        pass


def serve(folder):
    """The address of a server of a folder on this machine."""
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0),
                                             functools.partial(QuietHandler, directory=folder))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return "http://127.0.0.1:%d" % server.server_port


def open_browser():
    options = webdriver.ChromeOptions()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--hide-scrollbars"):
        options.add_argument(argument)
    return webdriver.Chrome(options=options,
                            service=webdriver.ChromeService("/usr/bin/chromedriver"))


def set_screen(browser, width, height):
    """The size of the page itself, without the frame of the browser, which has a least width."""
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": height, "deviceScaleFactor": 1,
                             "mobile": width < 600})


def wait_for(browser, condition):
    return WebDriverWait(browser, SECONDS).until(condition)


def search(browser, address):
    browser.get("%s/search.html?q=%s" % (address, WORD))
    found = wait_for(browser, lambda b: b.find_elements(By.CSS_SELECTOR, "#search-results li a"))
    print("search for '%s': %d pages at least" % (WORD, len(found)))


def open_scene(browser, address, name):
    browser.get("%s/scenes/%s.html" % (address, name))
    wait_for(browser,
             lambda b: b.find_element(By.TAG_NAME, "body").get_attribute("data-ready") == "yes")


def cut(browser, percent):
    browser.execute_script("cut.value = arguments[0]; cut.dispatchEvent(new Event('input'));",
                           percent)


def main():
    html, pictures = sys.argv[1:]
    os.makedirs(pictures, exist_ok=True)
    address = serve(html)
    browser = open_browser()
    try:
        for width, height in SCREENS:
            set_screen(browser, width, height)
            take = lambda name: browser.save_screenshot(
                os.path.join(pictures, "%s_%d.png" % (name, width)))
            browser.get(address + "/README.html")
            take("index")
            beyond = browser.execute_script(
                "return document.documentElement.scrollWidth - window.innerWidth")
            assert beyond <= 0, "the first page is %d pixels wider than a screen of %d" % (
                beyond, width)
            search(browser, address)
            take("search")
            browser.get(address + "/Documentation/user/tutorial.html")
            take("tutorial")
            for scene in ("splash", "ball_and_plate", "atlas"):
                open_scene(browser, address, scene)
                before = browser.get_screenshot_as_png()
                cut(browser, 30)
                take("scene_" + scene)
                assert before != browser.get_screenshot_as_png(), scene + " is not cut"
        print("pictures in " + pictures)
    finally:
        browser.quit()


if __name__ == "__main__":
    main()
