def build_study(d, p=None):
    pass
