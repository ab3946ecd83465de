#ifndef rolling_contact_scene_analysis_h
#define rolling_contact_scene_analysis_h

namespace RollingContact
{
  /**
   * What is asked of a scene: `Analysis` of the .prm file.
   */
  class Analysis
  {
  public:
    virtual ~Analysis() = default;

    /**
     * Compute, and write what is to be written. Throws ConvergenceError if that
     * is not possible.
     */
    virtual void run() = 0;
  };
} // namespace RollingContact

#endif
